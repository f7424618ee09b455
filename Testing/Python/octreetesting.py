# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the plugin share. Importing it connects to the server, if there is one, loads
the plugin, and puts the demo on the path."""
import os
import sys

from paraview import servermanager, simple, smtesting
from paraview.modules.vtkRemotingCore import vtkRemotingCoreConfiguration
from vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkDataObjectAlgorithm
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Plugin", "Demo"))

CELL_ARRAYS = ["Depth", "HitCost", "RootCost", "PointCount", "MortonKey"]
HISTOGRAM = ["Depth", "Leaves", "EmptyLeaves", "Points", "GridWeight"]
COSTS = ["StartDepth", "CostLeaves", "CostPoints", "CostGrid", "MeasuredLeaves", "MeasuredPoints",
         "ContinuousLeaves", "MeanHitCost"]
# Names of values of the properties that all filters have.
ENUMERATIONS = {
    "Dimension": ["Auto", "Two", "Three"],
    "Plane": ["Widest", "XY", "YZ", "XZ"],
    "FrequencyModel": ["Leaves", "Points", "Grid"],
    "StartDepthModel": ["Median", "Mean", "Root", "Fixed"],
}


def compare_with_baseline(view):
    """Ends the test where the view does not look like the picture -V."""
    smtesting.ProcessCommandLineArguments()
    if not smtesting.DoRegressionTesting(view.SMProxy):
        sys.exit("The picture differs from the baseline.")


def argument(option):
    """Value of -T (folder for output), -V (baseline image) or -D (Data)."""
    return sys.argv[sys.argv.index(option) + 1]


def write_sphere():
    """A file with points, in one piece: of several processes the first gets all of them. Returns
    its path and the number of points."""
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(64)
    sphere.SetPhiResolution(64)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(os.path.join(argument("-T"), "sphere.vtp"))
    writer.SetInputConnection(sphere.GetOutputPort())
    # Not appended: ParaView 5.11 cannot read that with the expat of Debian's security updates.
    writer.SetDataModeToBinary()
    assert writer.Write()
    return writer.GetFileName(), sphere.GetOutput().GetNumberOfPoints()


def _connect():
    # smTestDriver gives the address as --url, by which pvpython does not connect.
    url = vtkRemotingCoreConfiguration.GetInstance().GetServerURL()
    if url:
        host, port = url.split("//")[1].split(":")
        simple.Connect(host, int(port))


def _load_plugin():
    plugin = os.environ["HASHEDOCTREE_PLUGIN"]
    simple.LoadPlugin(plugin, remote=False)
    if servermanager.ActiveConnection.IsRemote():
        simple.LoadPlugin(plugin, remote=True)


def arrays(attributes):
    """The arrays of a vtkDataSetAttributes or vtkFieldData by name, as numpy arrays."""
    return {attributes.GetArrayName(i): vtk_to_numpy(attributes.GetArray(i))
            for i in range(attributes.GetNumberOfArrays())}


def fetch(octree, port):
    """Output of a port, brought to the client from all processes; a table from the first, which has
    all rows."""
    processes = servermanager.ActiveConnection.GetNumberOfDataPartitions()
    pieces = [servermanager.Fetch(octree, rank, idx=port) for rank in range(processes)]
    if processes == 1 or not pieces[0].IsA("vtkDataSet"):
        return pieces[0]
    # Without a rank ParaView 5.11 brings an unstructured grid from the first process only.
    append = vtkAppendPolyData() if pieces[0].IsA("vtkPolyData") else vtkAppendFilter()
    for piece in pieces:
        append.AddInputData(piece)
    append.Update()
    output = append.GetOutput()
    output.SetFieldData(pieces[0].GetFieldData())
    return output


def elements(property_):
    """All elements of a property as a tuple."""
    return tuple(property_.GetElement(i) for i in range(property_.GetNumberOfElements()))


def value_of(filter_, name):
    """A property of an instance of a vtk class as a tuple."""
    value = getattr(filter_, "Get" + name)()
    return value if isinstance(value, tuple) else (value,)


def check_properties(proxy, class_, enumerations=None, inputs=("Input",)):
    """Every property of the class is one of the proxy, with the same name, default, range and names
    of values (`enumerations` beside ENUMERATIONS), and there are no others but the inputs. Returns
    the names."""
    enumerations = {**ENUMERATIONS, **(enumerations or {})}
    own = set(dir(class_)) - set(dir(vtkDataObjectAlgorithm))
    names = {name[3:] for name in own
             if name.startswith("Set") and "Get" + name[3:] in own and "To" not in name[3:]}
    names.remove("Controller") # ParaView has one, the global controller.
    assert set(proxy.ListProperties()) == names | set(inputs), proxy.ListProperties()
    # Not through simple, where domains bring defaults of their own.
    fresh = servermanager.ProxyManager().NewProxy("filters", proxy.SMProxy.GetXMLName())
    for name in sorted(names):
        check_property(fresh.GetProperty(name), class_(), name, enumerations.get(name))
    return names


def check_property(property_, filter_, name, enumeration):
    """A property of a proxy is documented and has the default, range and entries of the class."""
    default = value_of(filter_, name)
    assert elements(property_) == default, (name, elements(property_), default)
    text = property_.GetDocumentation().GetDescription()
    assert text and len(text.strip()) > 20, name
    # What the domain does not allow, the class clamps.
    domain = property_.FindDomain("vtkSMIntRangeDomain")
    is_number = property_.IsA("vtkSMIntVectorProperty") and not property_.FindDomain("vtkSMBooleanDomain")
    assert domain or enumeration or not is_number, name
    if domain:
        for exists, limit, beyond in ((domain.GetMinimumExists(0), domain.GetMinimum(0), -2**31),
                                      (domain.GetMaximumExists(0), domain.GetMaximum(0), 2**31 - 1)):
            getattr(filter_, "Set" + name)(beyond)
            expected = limit if exists else beyond
            assert value_of(filter_, name) == (expected,), (name, value_of(filter_, name), expected)
    if enumeration:
        domain = property_.FindDomain("vtkSMEnumerationDomain")
        entries = {domain.GetEntryText(i): domain.GetEntryValue(i)
                   for i in range(domain.GetNumberOfEntries())}
        expected = {text: getattr(type(filter_), text) for text in enumeration}
        assert entries == expected, (name, entries, expected)


def check_values(proxy, class_, values):
    """Values given to the proxy reach the object that it stands for."""
    for name, value in values.items():
        setattr(proxy, name, value)
    proxy.UpdatePipeline()
    for name, value in values.items():
        value = getattr(class_, value) if isinstance(value, str) else value
        value = tuple(value) if isinstance(value, list) else (value,)
        actual = value_of(proxy.GetClientSideObject(), name)
        assert actual == value, (name, actual, value)


_connect()
_load_plugin()
