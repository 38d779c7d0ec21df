// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PartNames.h"

#include <Quantity_Color.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_ContextDependentOverRidingStyledItem.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Iterator.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <cmath>
#include <map>
#include <utility>

namespace sbvtk
{
namespace
{

using Color = std::array<std::uint8_t, 3>;

/** As the file has it: shares of the light that a screen shows. */
Color BytesOf(const Quantity_Color& color)
{
  std::array<Standard_Real, 3> shares{};
  color.Values(shares[0], shares[1], shares[2], Quantity_TOC_sRGB);
  Color bytes{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    bytes[k] = static_cast<std::uint8_t>(std::lround(255.0 * shares[k]));
  }
  return bytes;
}

/** What the file says of shapes, by what they have in common wherever they are placed. */
class Naming
{
public:
  Naming(const STEPControl_Reader& reader, PartNames& parts)
    : Process(reader.WS()->TransferReader()->TransientProcess())
    , Parts(parts)
  {
    this->ReadNames(*reader.StepModel());
    this->ReadColors(reader.WS());
  }

  /** A product at its place; it becomes a part with the first face of its own. */
  struct Product
  {
    const std::string* Name = nullptr; ///< null outside of all products
    std::int32_t Part = -1;
  };

  /** Go through a shape and all that it is made of. */
  void Visit(const TopoDS_Shape& shape, Product& within, FaceStyle style)
  {
    Product own;
    const auto name = this->NameOf.find(shape.TShape().get());
    own.Name = name != this->NameOf.end() ? &name->second : nullptr;
    Product& product = own.Name ? own : within;
    const auto color = this->ColorOf.find(shape.TShape().get());
    if (color != this->ColorOf.end())
    {
      style.HasColor = true;
      style.Color = color->second;
    }
    if (shape.ShapeType() == TopAbs_FACE)
    {
      style.Part = this->PartOf(product);
      this->Parts.StyleOfFace.Bind(shape, style);
      return;
    }
    for (TopoDS_Iterator child(shape); shape.ShapeType() < TopAbs_FACE && child.More();
         child.Next())
    {
      this->Visit(child.Value(), product, style);
    }
  }

private:
  using Key = const TopoDS_TShape*;

  std::int32_t PartOf(Product& product)
  {
    if (product.Name && product.Part < 0)
    {
      product.Part = static_cast<std::int32_t>(this->Parts.Names.size());
      this->Parts.Names.push_back(*product.Name);
    }
    return product.Part;
  }

  void ReadNames(const StepData_StepModel& model)
  {
    for (Standard_Integer i = 1; i <= model.NbEntities(); ++i)
    {
      const Handle(StepBasic_ProductDefinition) definition =
        Handle(StepBasic_ProductDefinition)::DownCast(model.Value(i));
      if (definition.IsNull() || definition->Formation().IsNull() ||
        definition->Formation()->OfProduct().IsNull())
      {
        continue;
      }
      const TopoDS_Shape made = TransferBRep::ShapeResult(this->Process, definition);
      const Handle(TCollection_HAsciiString) name = definition->Formation()->OfProduct()->Name();
      if (!made.IsNull())
      {
        this->NameOf[made.TShape().get()] = name.IsNull() ? "" : name->ToCString();
      }
    }
  }

  void ReadColors(const Handle(XSControl_WorkSession) & session)
  {
    STEPConstruct_Styles styles(session);
    if (!styles.LoadStyles())
    {
      return;
    }
    for (Standard_Integer i = 1; i <= styles.NbStyles(); ++i)
    {
      const Handle(StepVisual_StyledItem) style = styles.Style(i);
      Handle(StepVisual_Colour) surface, boundary, curve, rendered;
      Standard_Real transparency = 0.0;
      Standard_Boolean isComponent = Standard_False;
      Quantity_Color color;
      // A style for one place of a part only is left out.
      if (style.IsNull() || style->Item().IsNull() ||
        style->IsKind(STANDARD_TYPE(StepVisual_ContextDependentOverRidingStyledItem)) ||
        !styles.GetColors(style, surface, boundary, curve, rendered, transparency, isComponent) ||
        surface.IsNull() || !STEPConstruct_Styles::DecodeColor(surface, color))
      {
        continue;
      }
      const TopoDS_Shape shape = STEPConstruct::FindShape(this->Process, style->Item());
      if (!shape.IsNull())
      {
        this->ColorOf[shape.TShape().get()] = BytesOf(color);
      }
    }
  }

  const Handle(Transfer_TransientProcess) Process;
  PartNames& Parts;
  std::map<Key, std::string> NameOf;
  std::map<Key, Color> ColorOf;
};

} // namespace

PartNames FindPartNames(const STEPControl_Reader& reader, const TopoDS_Shape& shape)
{
  PartNames parts;
  if (!shape.IsNull())
  {
    Naming::Product none;
    Naming(reader, parts).Visit(shape, none, FaceStyle());
  }
  return parts;
}

} // namespace sbvtk
