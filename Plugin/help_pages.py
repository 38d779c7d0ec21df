# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the pages that F1 opens: one for each proxy of XML/, with its picture, and an index.

    python3 help_pages.py FOLDER PICTURES FILE.xml...

ParaView makes such pages by a program of Qt 5 only, and cannot put pictures into them. Qt's help shows HTML 4.
"""

import html
import pathlib
import re
import shutil
import sys
import xml.etree.ElementTree as ElementTree

ADVANCED = " Advanced: the gear beside the panel's search box shows it."


def inline(text):
    """*emphasis* and **strong emphasis** of reStructuredText; all else as it stands."""
    text = html.escape(text, quote=False)
    text = re.sub(r"\*\*([^*]+)\*\*", r"<b>\1</b>", text)
    return re.sub(r"\*([^*]+)\*", r"<em>\1</em>", text)


def paragraphs(text):
    return "\n".join(f"<p>{inline(part.strip())}</p>" for part in re.split(r"\n\s*\n", text.strip()))


def documentation(element):
    found = element.find("Documentation")
    return found.text if found is not None else ""


def default(editor):
    """As the panel shows it at first."""
    value = editor.get("default_values", "")
    if editor.find("BooleanDomain") is not None:
        return {"0": "off", "1": "on"}[value]
    for entry in editor.iterfind("EnumerationDomain/Entry"):
        if entry.get("value") == value:
            return entry.get("text")
    if editor.find("BoundsDomain") is not None:
        return "from the box around Input"
    return value


def rows(proxy):
    """(label, description, default) of all that a user can set, inputs first, then as the panel has them."""
    editors = {editor.get("name"): editor for editor in proxy if editor.tag.endswith("Property")}
    for editor in editors.values():
        if editor.tag == "InputProperty":
            yield editor.get("name"), inline(documentation(editor)), ""
    for group in proxy.iterfind("PropertyGroup"):
        for member in group.iterfind("Property"):
            editor = editors[member.get("name")]
            if editor.tag != "InputProperty":
                hint = ADVANCED if editor.get("panel_visibility") == "advanced" else ""
                yield editor.get("label"), inline(documentation(editor)) + hint, html.escape(default(editor))


def page(title, body):
    return f'<html><head><meta charset="utf-8"><title>{title}</title></head><body>\n<h2>{title}</h2>\n{body}\n</body></html>\n'


def proxy_page(name, proxy, picture):
    image = f'<p><img src="{name}.png"></p>\n' if picture else ""
    table = "\n".join(f"<tr><th>{label}</th><td>{text}</td><td>{value}</td></tr>" for label, text, value in rows(proxy))
    head = '<tr><th width="18%">Property</th><th>Description</th><th width="14%">Default</th></tr>'
    about = inline(proxy.find("Documentation").get("long_help"))
    return page(
        proxy.get("label"),
        f"<p><i>{about}</i></p>\n{image}{paragraphs(documentation(proxy))}\n"
        f'<table width="97%" border="1" cellspacing="0" cellpadding="4">\n{head}\n{table}\n</table>',
    )


def index(proxies):
    entries = (
        f'<dt><a href="{name}.html">{proxy.get("label")}</a></dt><dd>{inline(proxy.find("Documentation").get("short_help"))}</dd>'
        for name, proxy in proxies.items()
    )
    return page("Surface Booleans", "<dl>\n" + "\n".join(entries) + "\n</dl>")


def main(folder, pictures, *files):
    folder, pictures = pathlib.Path(folder), pathlib.Path(pictures)
    shutil.rmtree(folder, ignore_errors=True)  # pages of what is no more would stay in the help
    folder.mkdir(parents=True)
    proxies = {}
    for file in files:
        for group in ElementTree.parse(file).getroot():
            proxies.update({f"{group.get('name')}.{proxy.get('name')}": proxy for proxy in group})
    for name, proxy in proxies.items():
        picture = pictures / f"{name}.png"
        if picture.exists():
            shutil.copy(picture, folder)
        (folder / f"{name}.html").write_text(proxy_page(name, proxy, picture.exists()), encoding="utf-8")
    (folder / "index.html").write_text(index(proxies), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
