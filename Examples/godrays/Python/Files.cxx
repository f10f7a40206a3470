// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The module godrays._files of Python: makes props of files as the program does, by the same code.
 */

#include "vtkPython.h" // before all others

#include "Failure.h"
#include "Progress.h"
#include "Scene.h"

#include "vtkPythonUtil.h"

#include <cstddef>

namespace
{
//------------------------------------------------------------------------------
/// Appends to a list an object that becomes the list's. Returns whether that succeeded.
bool Append(PyObject* list, PyObject* object)
{
  const bool isAppended = object && PyList_Append(list, object) == 0;
  Py_XDECREF(object);
  return isAppended;
}

//------------------------------------------------------------------------------
/// Reads the arguments, and the files. Returns false if an exception of Python is set.
bool ReadScene(PyObject* arguments, Scene& scene)
{
  PyObject* names = nullptr;
  const char* scalars = nullptr;
  PyObject* color = nullptr;
  PyObject* colors = nullptr;
  Options options;
  if (!PyArg_ParseTuple(arguments, "O!sOdO!", &PyList_Type, &names, &scalars, &color,
        &options.Opacity, &PyList_Type, &colors))
  {
    return false;
  }
  options.Scalars = scalars;
  Vector3 rgb;
  for (Py_ssize_t i = 0; i < PyList_Size(colors); ++i)
  {
    if (!PyArg_ParseTuple(PyList_GetItem(colors, i), "ddd", &rgb[0], &rgb[1], &rgb[2]))
    {
      return false;
    }
    options.Colors.push_back(rgb);
  }
  if (color != Py_None)
  {
    if (!PyArg_ParseTuple(color, "ddd", &rgb[0], &rgb[1], &rgb[2]))
    {
      return false;
    }
    options.Color = rgb;
  }
  for (Py_ssize_t i = 0; i < PyList_Size(names); ++i)
  {
    char* name = nullptr;
    Py_ssize_t length = 0;
    if (PyBytes_AsStringAndSize(PyList_GetItem(names, i), &name, &length) < 0)
    {
      return false;
    }
    options.Files.emplace_back(name, static_cast<std::size_t>(length));
  }
  Progress::SetQuiet(true);
  try
  {
    std::vector<FileContents> files;
    for (const std::string& name : options.Files)
    {
      files.push_back(ReadFile(name, {}));
      const auto& notes = files.back().Notes;
      scene.Notes.insert(scene.Notes.end(), notes.begin(), notes.end());
    }
    Scene made = MakeScene(files, options);
    made.Notes.insert(made.Notes.begin(), scene.Notes.begin(), scene.Notes.end());
    scene = made;
    if (!options.Colors.empty() && scene.Arrays.empty())
    {
      throw Failure("--cmap is for scalars, and the files have none; leave it out");
    }
    return true;
  }
  catch (const std::exception& failure)
  {
    PyErr_SetString(PyExc_RuntimeError, failure.what());
    return false;
  }
}

//------------------------------------------------------------------------------
PyObject* MakeProps(PyObject*, PyObject* arguments)
{
  Scene scene;
  if (!ReadScene(arguments, scene))
  {
    return nullptr;
  }
  PyObject* props = PyList_New(0);
  PyObject* notes = PyList_New(0);
  bool isGood = props && notes;
  for (const auto& prop : scene.Props)
  {
    isGood = isGood && Append(props, vtkPythonUtil::GetObjectFromPointer(prop));
  }
  for (const std::string& note : scene.Notes)
  {
    isGood = isGood && Append(notes, PyUnicode_DecodeFSDefault(note.c_str()));
  }
  PyObject* both = isGood ? PyTuple_Pack(2, props, notes) : nullptr;
  Py_XDECREF(props);
  Py_XDECREF(notes);
  return both;
}

PyMethodDef methods[] = {
  { "make_props", MakeProps, METH_VARARGS,
    "make_props(files: list[bytes], scalars: str, color: tuple | None, opacity: float, colors: "
    "list)\n\n"
    "Return the props of files, and notes for the user. RuntimeError: what is wrong, and what to "
    "do." },
  { nullptr, nullptr, 0, nullptr },
};
PyModuleDef module = { PyModuleDef_HEAD_INIT, "_files", nullptr, -1, methods, nullptr, nullptr,
  nullptr, nullptr };
}

//------------------------------------------------------------------------------
PyMODINIT_FUNC PyInit__files()
{
  return PyModule_Create(&module);
}
