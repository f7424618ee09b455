# SPDX-License-Identifier: BSD-3-Clause
"""Points for the demo, from anything that ParaView reads and from text files with columns."""
import os

from paraview import simple
from vtkmodules.vtkCommonCore import VTK_STRING

GOOD_FILES = "give a file with points, such as .ply .obj .stl .vtp .vtk .vtu, or .csv, .txt or .xyz with columns"
TEXT_FILES = ".csv", ".tsv", ".txt", ".xyz", ".asc"
# Names of columns: as scanners write them, as ParaView does, and as it calls those without names.
COORDINATES = ("xyz", ("points:0", "points:1", "points:2"), ("points_0", "points_1", "points_2"),
               ("field 0", "field 1", "field 2"))


class DemoError(Exception):
    """What went wrong and what to do, in one line."""


def read_points(path):
    """A source whose output is one data set with explicit points."""
    if not path:
        raise DemoError("no file; name one in HASHEDOCTREE_FILE")
    if not os.path.isfile(path):
        raise DemoError(f"{path} {'is not a file' if os.path.exists(path) else 'does not exist'}; "
                        "give a file with points")
    if not os.access(path, os.R_OK):
        raise DemoError(f"{path} may not be read; change its permissions or give another file")
    try:
        source = open_rows(path) if path.lower().endswith(TEXT_FILES) else simple.OpenDataFile(path)
    except UnicodeEncodeError:
        raise DemoError(f"the name of {path} is not UTF-8, which ParaView needs; rename it") from None
    except RuntimeError:
        source = None
    if not source:
        raise DemoError(f"ParaView cannot read {path}; {GOOD_FILES}")
    simple.RenameSource(os.path.basename(path), source)
    source.UpdatePipeline()
    source = to_point_set(source, path)
    if source.GetDataInformation().GetNumberOfPoints() == 0:
        if has_appended_data(path):
            raise DemoError(f"{path} gave no points; if it holds some, save it as ascii or inline binary: ParaView 5.11"
                            " cannot read appended data with the expat of Debian's security updates")
        raise DemoError(f"ParaView finds no points in {path}; {GOOD_FILES}")
    return source


def open_rows(path):
    """A reader of the rows of a text file, with semicolons, commas, tabs or spaces between the columns, and with or
    without their names above them, which may stand behind # or //."""
    with open(path, encoding="utf-8-sig", errors="replace") as file:
        first_row = file.readline().strip()
    delimiter = next((mark for mark in ";,\t" if mark in first_row), None)
    # Between spaces a # before the names is no name of its own.
    return simple.CSVReader(FileName=[path], FieldDelimiterCharacters=delimiter or " \t#",
                            MergeConsecutiveDelimiters=not delimiter,
                            HaveHeaders=not all(map(is_number, first_row.split(delimiter))))


def is_number(text):
    try:
        float(text.strip(' "') or 0)
        return True
    except ValueError:
        return False


def has_appended_data(path):
    """Whether a file is one of VTK's XML formats with its arrays after the XML."""
    with open(path, "rb") as file:
        return b"<VTKFile" in file.read(1024) and b"<AppendedData" in file.read()


def to_point_set(source, path):
    """Blocks become one data set, rows of a table points, and a grid with implied points gets explicit ones."""
    information = source.GetDataInformation().DataInformation
    if information.IsCompositeDataSet():
        source = simple.MergeBlocks(Input=source, MergePoints=0)
        source.UpdatePipeline()
        information = source.GetDataInformation().DataInformation
    if information.DataSetTypeIsA("vtkTable"):
        return to_points(source, path)
    if not information.DataSetTypeIsA("vtkDataSet"):
        raise DemoError(f"ParaView reads {path} as a {information.GetDataClassName()}, which is no data set with "
                        "points; give it in another format")
    if not information.DataSetTypeIsA("vtkPointSet"):
        source = simple.ConvertToPointCloud(Input=source)
        source.UpdatePipeline()
    return source


def to_points(rows, path):
    """Points from the columns of a table that have the names of COORDINATES."""
    information = rows.GetDataInformation().DataInformation
    row_data = information.GetRowDataInformation()
    every = [row_data.GetArrayInformation(i) for i in range(row_data.GetNumberOfArrays())]
    if not every:
        raise DemoError(f"{path} is a table without rows, or not in UTF-8; give one with points")
    if not all(column.GetName() for column in every):  # ParaView 5.11 crashes where it lists them
        raise DemoError(f"{path} has a column without a name; name all in its first line, and end it behind the last")
    columns = {column.GetName().strip(" #/").lower(): column for column in every}
    for names in COORDINATES:
        if all(name in columns for name in names):
            for name in names:
                check_column(name, columns[name], information.GetNumberOfRows(), path)
            points = simple.TableToPoints(Input=rows)
            points.XColumn, points.YColumn, points.ZColumn = (columns[name].GetName() for name in names)
            points.UpdatePipeline()
            return points
    raise DemoError(f"{path} is a table with the columns {', '.join(columns)[:60]}, without x, y and z; name those of"
                    " the coordinates so, in its first line, or give one without names that begins with them")


def check_column(name, column, number_of_rows, path):
    if column.GetDataType() == VTK_STRING:
        raise DemoError(f"column {name} of {path} holds words; give a number in each row, with a decimal point")
    if column.GetNumberOfTuples() < number_of_rows:  # TableToPoints would read behind it
        raise DemoError(f"column {name} of {path} ends early; give a number in each row")
