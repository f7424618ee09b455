# SPDX-License-Identifier: BSD-3-Clause
"""A proxy against the class that it stands for: names, defaults, ranges, values."""
from paraview import servermanager


def value_of(filter_, name):
    value = getattr(filter_, "Get" + name)()
    return value if isinstance(value, tuple) else (value,)


def check_proxy(proxy_name, class_, enumerations):
    """Every property of the class is one of the proxy in the group "filters", with the same
    default, range and names of values (`enumerations`, a list for each such property), and is
    documented. Returns the names of the properties."""
    own = set(dir(class_)) - set(dir(class_.__bases__[0]))
    names = {name[3:] for name in own
             if name.startswith("Set") and "Get" + name[3:] in own and "To" not in name[3:]}
    # Not through simple, where domains bring defaults of their own.
    proxy = servermanager.ProxyManager().NewProxy("filters", proxy_name)
    filter_ = class_()
    for name in sorted(names):
        property_ = proxy.GetProperty(name)
        # Defaults.
        elements = tuple(property_.GetElement(i) for i in range(property_.GetNumberOfElements()))
        assert elements == value_of(filter_, name), (name, elements, value_of(filter_, name))
        _check_documentation(property_)
        # Ranges: what the domain does not allow, the class clamps.
        domain = property_.FindDomain("vtkSMIntRangeDomain")
        if domain:
            for exists, limit, beyond in (
                    (domain.GetMinimumExists(0), domain.GetMinimum(0), -2**31),
                    (domain.GetMaximumExists(0), domain.GetMaximum(0), 2**31 - 1)):
                getattr(filter_, "Set" + name)(beyond)
                expected = limit if exists else beyond
                assert value_of(filter_, name) == (expected,), (name, value_of(filter_, name))
        # Names of values.
        domain = property_.FindDomain("vtkSMEnumerationDomain")
        if name in enumerations:
            entries = {domain.GetEntryText(i): domain.GetEntryValue(i)
                       for i in range(domain.GetNumberOfEntries())}
            expected = {text: getattr(class_, text) for text in enumerations[name]}
            assert entries == expected, (name, entries, expected)
    return names


def check_values(proxy, class_, values):
    """Values that are set in the proxy reach the object that it stands for."""
    for name, value in values.items():
        setattr(proxy, name, value)
    proxy.UpdatePipeline()
    filter_ = proxy.GetClientSideObject()
    for name, value in values.items():
        value = getattr(class_, value) if isinstance(value, str) else value
        value = tuple(value) if isinstance(value, list) else (value,)
        assert value_of(filter_, name) == value, (name, value_of(filter_, name), value)


def _check_documentation(property_):
    text = property_.GetDocumentation().GetDescription()
    assert text and len(text.strip()) > 20, property_.GetXMLName()
