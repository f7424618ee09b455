# SPDX-License-Identifier: BSD-3-Clause
"""The pages that ParaView shows for the button "?" of a panel: one for each filter and the locator,
with all their properties, and all columns of the tables that are drawn."""
import os
import sqlite3
import zlib
from pathlib import Path
from xml.etree import ElementTree


def read_pages():
    """Qt's file of help: its pages by name."""
    with sqlite3.connect(os.environ["HASHEDOCTREE_HELP"]) as database:
        rows = database.execute("SELECT Name, Data FROM FileNameTable "
                                "JOIN FileDataTable ON FileId = Id WHERE Name != ''").fetchall()
    # Four bytes tell the size of the text.
    return {name: zlib.decompress(data[4:]).decode() for name, data in rows}


pages = read_pages()
plugin = Path(__file__).resolve().parents[2] / "Plugin"
proxies = [(group.get("name"), proxy)
           for file in sorted(plugin.glob("*.xml"))
           for group in ElementTree.parse(file).getroot().iter("ProxyGroup")
           for proxy in group
           if group.get("name") in ("filters", "point_locators") and proxy.tag.endswith("Proxy")]
assert len(proxies) == 4, proxies
for group, proxy in proxies:
    page = pages[f"{group.replace('_', '_u')}.{proxy.get('name')}.html"]
    assert proxy.get("label") in page
    labels = [property_.get("label") or property_.get("name") for property_ in proxy
              if property_.tag.endswith("Property") and property_.get("panel_visibility") != "never"]
    assert len(labels) > 3, labels
    for label in labels:
        assert label in page, (proxy.get("name"), label)

drawn = [element.get("default_values").split(";")[::2]
         for element in ElementTree.parse(plugin / "HashedOctreeCharts.xml").iter()
         if element.get("name") == "SeriesVisibility"]
assert [len(columns) for columns in drawn] == [13, 13], drawn
for column in sum(drawn, []):
    assert column in pages["filters.HashedOctree.html"], column
