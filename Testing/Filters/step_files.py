# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""STEP files of simple solids, written entity by entity, so that nothing under test has made them."""

import math


class StepFile:
    """Entities of ISO 10303-21, numbered as they come."""

    def __init__(self, unit="MILLI"):
        self.lines = []
        length = "SI_UNIT($,.METRE.)" if unit is None else f"SI_UNIT(.{unit}.,.METRE.)"
        units = [
            self.add(f"( LENGTH_UNIT() NAMED_UNIT(*) {length} )"),
            self.add("( NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.) )"),
            self.add("( NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT() )"),
        ]
        accuracy = self.add(f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),{units[0]},'','')")
        self.context = self.add(
            "( GEOMETRIC_REPRESENTATION_CONTEXT(3) "
            f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({accuracy})) "
            f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({','.join(units)})) REPRESENTATION_CONTEXT('','') )"
        )
        self.application = self.add("APPLICATION_CONTEXT('mechanical design')")

    def add(self, text):
        self.lines.append(text)
        return f"#{len(self.lines)}"

    def point(self, x):
        return self.add("CARTESIAN_POINT('',(%s))" % ",".join(repr(float(c)) for c in x))

    def axes(self, origin=(0, 0, 0), axis=(0, 0, 1), reference=(1, 0, 0)):
        z, x = (self.add("DIRECTION('',(%s))" % ",".join(repr(float(c)) for c in d)) for d in (axis, reference))
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.point(origin)},{z},{x})")

    def vertex(self, x):
        return self.add(f"VERTEX_POINT('',{self.point(x)})")

    def edge(self, start, end, curve):
        return self.add(f"EDGE_CURVE('',{start},{end},{curve},.T.)")

    def loop(self, *edges):
        """Of (edge, along it or not)."""
        parts = [self.add(f"ORIENTED_EDGE('',*,*,{e},.{'T' if along else 'F'}.)") for e, along in edges]
        return self.add(f"EDGE_LOOP('',({','.join(parts)}))")

    def face(self, surface, *loops, same=True):
        bounds = [self.add(f"FACE_{'OUTER_' if i == 0 else ''}BOUND('',{l},.T.)") for i, l in enumerate(loops)]
        return self.add(f"ADVANCED_FACE('',({','.join(bounds)}),{surface},.{'T' if same else 'F'}.)")

    def solid(self, *faces):
        shell = self.add(f"CLOSED_SHELL('',({','.join(faces)}))")
        return self.add(f"MANIFOLD_SOLID_BREP('',{shell})")

    def product(self, *items, kind="ADVANCED_BREP_SHAPE_REPRESENTATION", name="body"):
        """One product of these solids (or other items); its definition and its representation."""
        a = self.application
        context = self.add(f"PRODUCT_CONTEXT('',{a},'mechanical')")
        product = self.add(f"PRODUCT('{name}','{name}','',({context}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        stage = self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{a},'design')")
        definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{stage})")
        shape = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
        representation = self.add(f"{kind}('',({','.join(items)}),{self.context})")
        self.add(f"SHAPE_DEFINITION_REPRESENTATION({shape},{representation})")
        return definition, representation

    def place(self, whole, part, own, there):
        """The part as a component of the whole: its axes `own` come to lie on the axes `there`."""
        use = self.add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('','','',{whole[0]},{part[0]},$)")
        shape = self.add(f"PRODUCT_DEFINITION_SHAPE('','',{use})")
        move = self.add(f"ITEM_DEFINED_TRANSFORMATION('','',{own},{there})")
        relation = self.add(
            f"( REPRESENTATION_RELATIONSHIP('','',{part[1]},{whole[1]}) "
            f"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({move}) SHAPE_REPRESENTATION_RELATIONSHIP() )"
        )
        self.add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{shape})")

    def paint(self, item, red, green, blue):
        """Give a solid or a face a colour."""
        color = self.add(f"COLOUR_RGB('',{red!r},{green!r},{blue!r})")
        filling = self.add(f"FILL_AREA_STYLE_COLOUR('',{color})")
        fill = self.add(f"FILL_AREA_STYLE('',({filling}))")
        area = self.add(f"SURFACE_STYLE_FILL_AREA({fill})")
        side = self.add(f"SURFACE_SIDE_STYLE('',({area}))")
        usage = self.add(f"SURFACE_STYLE_USAGE(.BOTH.,{side})")
        assignment = self.add(f"PRESENTATION_STYLE_ASSIGNMENT(({usage}))")
        styled = self.add(f"STYLED_ITEM('color',({assignment}),{item})")
        self.add(f"MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',({styled}),{self.context})")

    def write(self, path):
        data = "\n".join(f"#{i + 1}={text};" for i, text in enumerate(self.lines))
        path.write_text(
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
            f"FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n{data}\nENDSEC;\nEND-ISO-10303-21;\n"
        )
        return str(path)


def cylinder(step, radius, height):
    """About z, on the plane z = 0."""
    bottom, top = step.vertex((radius, 0, 0)), step.vertex((radius, 0, height))
    low, high = step.axes(), step.axes((0, 0, height))
    rim = [step.edge(v, v, step.add(f"CIRCLE('',{a},{radius!r})")) for v, a in ((bottom, low), (top, high))]
    direction = step.add("DIRECTION('',(0.,0.,1.))")
    up = step.add(f"VECTOR('',{direction},1.)")
    seam = step.edge(bottom, top, step.add(f"LINE('',{step.point((radius, 0, 0))},{up})"))
    side = step.face(
        step.add(f"CYLINDRICAL_SURFACE('',{low},{radius!r})"),
        step.loop((rim[0], True), (seam, True), (rim[1], False), (seam, False)),
    )
    lid = step.face(step.add(f"PLANE('',{high})"), step.loop((rim[1], True)))
    floor = step.face(step.add(f"PLANE('',{low})"), step.loop((rim[0], False)), same=False)
    return step.solid(side, lid, floor)


def sphere(step, radius, center=(0, 0, 0)):
    return step.solid(sphere_face(step, radius, center))


def hollow_sphere(step, radius, hollow):
    """A ball with a ball taken out of its middle: a shell inside of the other, turned round."""
    outer = step.add(f"CLOSED_SHELL('',({sphere_face(step, radius)}))")
    inner = step.add(f"CLOSED_SHELL('',({sphere_face(step, hollow)}))")
    void = step.add(f"ORIENTED_CLOSED_SHELL('',*,{inner},.F.)")
    return step.add(f"BREP_WITH_VOIDS('',{outer},({void}))")


def sphere_face(step, radius, center=(0, 0, 0)):
    """One face between its poles, with a seam from one to the other."""
    south, north = (step.vertex((center[0], center[1], center[2] + z)) for z in (-radius, radius))
    meridian = step.add(f"CIRCLE('',{step.axes(center, (0, -1, 0), (1, 0, 0))},{radius!r})")
    seam = step.edge(south, north, meridian)
    surface = step.add(f"SPHERICAL_SURFACE('',{step.axes(center)},{radius!r})")
    return step.face(surface, step.loop((seam, True), (seam, False)))


def torus(step, ring, tube):
    start = step.vertex((ring + tube, 0, 0))
    around = step.edge(start, start, step.add(f"CIRCLE('',{step.axes()},{ring + tube!r})"))
    across = step.add(f"CIRCLE('',{step.axes((ring, 0, 0), (0, -1, 0), (1, 0, 0))},{tube!r})")
    through = step.edge(start, start, across)
    surface = step.add(f"TOROIDAL_SURFACE('',{step.axes()},{ring!r},{tube!r})")
    return step.solid(
        step.face(surface, step.loop((around, True), (through, True), (around, False), (through, False)))
    )


VOLUMES = {
    "cylinder": lambda radius, height: math.pi * radius**2 * height,
    "sphere": lambda radius: 4 / 3 * math.pi * radius**3,
    "hollow_sphere": lambda radius, hollow: 4 / 3 * math.pi * (radius**3 - hollow**3),
    "torus": lambda ring, tube: 2 * math.pi**2 * ring * tube**2,
}
AREAS = {
    "cylinder": lambda radius, height: 2 * math.pi * radius * (radius + height),
    "sphere": lambda radius: 4 * math.pi * radius**2,
    "hollow_sphere": lambda radius, hollow: 4 * math.pi * (radius**2 + hollow**2),
    "torus": lambda ring, tube: 4 * math.pi**2 * ring * tube,
}
