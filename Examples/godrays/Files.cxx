// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files.h"

#include "DataChecks.h"
#include "Failure.h"
#include "FileChecks.h"
#include "GltfFile.h"
#include "GltfImporter.h"
#include "ImageHeaders.h"
#include "Messages.h"
#include "ObjMaterials.h"
#include "PlyStrips.h"
#include "Progress.h"
#include "Series.h"
#include "System.h"
#include "TiffPicture.h"
#include "UpAxis.h"

#include "vtk3DSImporter.h"
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkBMPReader.h"
#include "vtkBYUReader.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDEMReader.h"
#include "vtkDataSet.h"
#include "vtkExodusIIReader.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkHDRReader.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkJPEGReader.h"
#include "vtkMapper.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPNGReader.h"
#include "vtkPNMReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSTLReader.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTIFFReader.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPImageDataReader.h"
#include "vtkXMLPPolyDataReader.h"
#include "vtkXMLPRectilinearGridReader.h"
#include "vtkXMLPStructuredGridReader.h"
#include "vtkXMLPUnstructuredGridReader.h"
#include "vtkXMLPartitionedDataSetCollectionReader.h"
#include "vtkXMLPartitionedDataSetReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtk_tiff.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

namespace
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
void AddDataObject(vtkDataObject* object, FileContents& contents)
{
  if (auto* dataSet = vtkDataSet::SafeDownCast(object))
  {
    CheckSizes(contents.Path, dataSet);
    CheckCells(contents.Path, dataSet);
    contents.DataSets.emplace_back(dataSet);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(object))
  {
    auto leaves = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      AddDataObject(leaves->GetCurrentDataObject(), contents);
    }
  }
  else if (object)
  {
    throw Failure(contents.Path + ": holds a " + object->GetClassName() +
      ", which has no shape; give a file with points and cells");
  }
}

//------------------------------------------------------------------------------
/**
 * Which of the times is the nearest to the one asked for.
 */
std::size_t FindStep(const FileContents& contents)
{
  const auto& times = contents.Times;
  const double time = contents.Time.value_or(times.front());
  const auto nearest = std::min_element(times.begin(), times.end(),
    [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
  return static_cast<std::size_t>(nearest - times.begin());
}

//------------------------------------------------------------------------------
template <typename Reader>
void Update(Reader* reader, const std::string& path, FileContents& contents)
{
  reader->SetFileName(path.c_str());
  const Progress progress(reader, "reading " + contents.Path);
  reader->UpdateInformation();
  vtkInformation* information = reader->GetOutputInformation(0);
  auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (information && information->Has(key) && information->Length(key) > 0)
  {
    const double* times = information->Get(key);
    contents.Times.assign(times, times + information->Length(key));
    reader->UpdateTimeStep(contents.Times[FindStep(contents)]);
  }
  else
  {
    reader->Update();
  }
  AddDataObject(reader->GetOutputDataObject(0), contents);
}

//------------------------------------------------------------------------------
template <typename Reader>
void ReadXml(const std::string& path, FileContents& contents)
{
  CheckXml(path);
  CheckXmlParts(path);
  vtkNew<Reader> reader;
  Update(reader.Get(), path, contents);
}

//------------------------------------------------------------------------------
template <typename Reader>
void ReadData(const std::string& path, FileContents& contents)
{
  vtkNew<Reader> reader;
  Update(reader.Get(), path, contents);
}

//------------------------------------------------------------------------------
/**
 * A white texel, which stands for a missing picture, leaves the colours as they are.
 */
bool ChangesColors(vtkTexture* texture)
{
  texture->Update();
  vtkImageData* image = texture->GetInput();
  return image && image->GetNumberOfPoints() > 0 &&
    (image->GetNumberOfPoints() > 1 || image->GetScalarRange()[0] < 255.0 ||
      image->GetNumberOfScalarComponents() % 2 == 0); // with opacity
}

//------------------------------------------------------------------------------
/**
 * Materials that reflect their surroundings are black where there are none: keep their colours.
 */
void SimplifyMaterial(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  property->SetInterpolationToPhong();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.2);
  property->SetSpecularPower(20.0);
  vtkTexture* texture = property->GetTexture("albedoTex");
  if (texture && ChangesColors(texture))
  {
    texture->UseSRGBColorSpaceOff();
    actor->SetTexture(texture);
  }
  property->RemoveAllTextures();
}

//------------------------------------------------------------------------------
void ImportActors(vtkImporter* importer, FileContents& contents)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window; // holds the renderer; it is never opened
  window->AddRenderer(renderer);
  importer->SetRenderWindow(window);
  const Progress progress(importer, "reading " + contents.Path);
  importer->Update();
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    if (actor->GetMapper())
    {
      actor->GetMapper()->Update();
      CheckCells(contents.Path, actor->GetMapper()->GetInput());
      SimplifyMaterial(actor);
      contents.Actors.emplace_back(actor);
    }
  }
}

//------------------------------------------------------------------------------
template <typename Importer>
void Import(const std::string& path, FileContents& contents)
{
  vtkNew<Importer> importer;
  importer->SetFileName(path.c_str());
  ImportActors(importer, contents);
}

//------------------------------------------------------------------------------
void ReadGltf(const std::string& path, FileContents& contents)
{
  const GltfFile file(path);
  for (const std::string& name : file.GetMissingPictures())
  {
    contents.Notes.push_back(path + ": its picture " + name +
      " is missing, so there is a plain colour; put the picture where the file looks for it");
  }
  Import<GltfImporter>(file.GetPathToRead(), contents);
  contents.Up = 'Y';
}

//------------------------------------------------------------------------------
/**
 * Of types in which one axis usually points up, Y or Z, and the other one does in some files.
 */
void GuessUp(FileContents& contents, char usual)
{
  const char other = usual == 'Y' ? 'Z' : 'Y';
  const std::string reason =
    GetReasonForUp(vtkPolyData::SafeDownCast(contents.DataSets.front()), other);
  contents.Up = reason.empty() ? usual : other;
  if (!reason.empty())
  {
    contents.UpNote = contents.Path + ": taken for one in which " + other + " points up, as " +
      reason + "; --up " + usual + " if it is not so";
  }
}

//------------------------------------------------------------------------------
void ReadStl(const std::string& path, FileContents& contents)
{
  CheckStl(path);
  ReadData<vtkSTLReader>(path, contents);
  GuessUp(contents, 'Z');
}

//------------------------------------------------------------------------------
void ReadObj(const std::string& path, FileContents& contents)
{
  ReadData<vtkOBJReader>(path, contents);
  auto* data = vtkPolyData::SafeDownCast(contents.DataSets.front());
  data->GetCellData()->RemoveArray("MaterialIds"); // numbers are nothing to colour by
  data->GetCellData()->RemoveArray("GroupIds");
  const auto colors = ReadObjFaceColors(path, contents.Notes);
  if (colors->GetNumberOfTuples() > 0 && colors->GetNumberOfTuples() == data->GetNumberOfCells())
  {
    data->GetCellData()->SetScalars(colors);
  }
  GuessUp(contents, 'Y');
}

//------------------------------------------------------------------------------
void ReadPly(const std::string& path, FileContents& contents)
{
  ReadData<vtkPLYReader>(path, contents);
  auto* data = vtkPolyData::SafeDownCast(contents.DataSets.front());
  const auto strips = ReadPlyStrips(path);
  if (strips->GetNumberOfCells() > 0)
  {
    data->GetCellData()->Initialize(); // has values for faces alone
    data->SetStrips(strips);
    CheckCells(path, data);
  }
  GuessUp(contents, 'Y');
}

//------------------------------------------------------------------------------
void ReadTiff(const std::string& path, FileContents& contents)
{
  contents.Place = ReadGeoTiffTags(path);
  if (!contents.Place.Unread.empty())
  {
    contents.Notes.push_back(path + ": " + contents.Place.Unread);
  }
  if (const auto picture = ReadCompressedTiff(path))
  {
    AddDataObject(picture, contents);
    return;
  }
  vtkNew<vtkTIFFReader> reader;
  // VTK takes the first row, which is at the top, for the lowest one, but not if it is told the reverse.
  reader->SetOrientationType(ORIENTATION_BOTLEFT);
  Update(reader.Get(), path, contents);
}

//------------------------------------------------------------------------------
void ReadDem(const std::string& path, FileContents& contents)
{
  vtkNew<vtkDEMReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetElevationReferenceToSeaLevel();
  reader->UpdateInformation();
  constexpr int fewest = 100; // VTK divides by the hundredth part of their number
  if (reader->GetProfileDimension()[1] < fewest)
  {
    throw Failure(path +
      ": is no DEM, or one of less than 100 columns, which VTK cannot read; "
      "convert it to .tif");
  }
  Update(reader.Get(), path, contents);
  auto* picture = vtkImageData::SafeDownCast(contents.DataSets.front());
  contents.Place.Known = true;
  contents.Place.Column[0] = picture->GetSpacing()[0];
  contents.Place.Row[1] = picture->GetSpacing()[1];
  if (reader->GetGroundSystem() == 0)
  {
    // In arc-seconds: VTK takes each for as long as one on a sphere's equator, in both directions,
    // and leaves the origin as it is.
    constexpr double degree = 6.38e6 * 3.14159265358979 / 180.0;
    const double* bounds = picture->GetBounds();
    const double height = (bounds[3] - bounds[2]) / degree;
    double lengths[2];
    GetDegreeLengths(picture->GetOrigin()[1] / 3600.0 + 0.5 * height, lengths);
    contents.Place.Column[0] *= lengths[0] / degree;
    contents.Place.Row[1] *= lengths[1] / degree;
  }
}

//------------------------------------------------------------------------------
/**
 * Read an image whose header says more than VTK's reader applies.
 */
template <typename Reader>
void ReadImage(const std::string& path, FileContents& contents)
{
  CheckDataFiles(path);
  vtkNew<Reader> reader;
  Update(reader.Get(), path, contents);
  if (reader->GetOutput()->GetPointData()->GetScalars())
  {
    contents.DataSets = { ApplyHeader(path, reader) };
  }
}

//------------------------------------------------------------------------------
void ReadNrrd(const std::string& path, FileContents& contents)
{
  CheckNrrd(path);
  ReadImage<vtkNrrdReader>(path, contents);
}

//------------------------------------------------------------------------------
void Read3ds(const std::string& path, FileContents& contents)
{
  Check3ds(path);
  Import<vtk3DSImporter>(path, contents);
}

//------------------------------------------------------------------------------
void ReadByu(const std::string& path, FileContents& contents)
{
  CheckByu(path);
  ReadData<vtkBYUReader>(path, contents);
}

//------------------------------------------------------------------------------
void ReadPng(const std::string& path, FileContents& contents)
{
  CheckPng(path);
  ReadData<vtkPNGReader>(path, contents);
}

//------------------------------------------------------------------------------
void ReadPnm(const std::string& path, FileContents& contents)
{
  CheckPnm(path);
  ReadData<vtkPNMReader>(path, contents);
}

//------------------------------------------------------------------------------
void ReadHdr(const std::string& path, FileContents& contents)
{
  CheckHdr(path);
  ReadData<vtkHDRReader>(path, contents);
}

//------------------------------------------------------------------------------
/**
 * Read a file that another one names.
 */
void ReadPart(FileContents& contents);

//------------------------------------------------------------------------------
void ReadExodus(const std::string& path, FileContents& contents)
{
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  reader->SetAllArrayStatus(vtkExodusIIReader::ELEM_BLOCK, 1);
  Update(reader.Get(), path, contents);
}

//------------------------------------------------------------------------------
/**
 * Of files by time and part, those of the time nearest to the one asked for.
 */
void ReadSeries(const std::string& path, FileContents& contents)
{
  const auto parts = ReadSeriesParts(path);
  auto& times = contents.Times;
  for (const auto& [time, file] : parts)
  {
    times.push_back(time);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  const double nearest = times[FindStep(contents)];
  for (const auto& [time, file] : parts)
  {
    if (time == nearest)
    {
      FileContents part;
      part.Path = file;
      ReadPart(part);
      contents.DataSets.insert(contents.DataSets.end(), part.DataSets.begin(), part.DataSets.end());
      contents.Actors.insert(contents.Actors.end(), part.Actors.begin(), part.Actors.end());
      contents.Up = part.Up;
      contents.UpNote = part.UpNote;
    }
  }
}

//------------------------------------------------------------------------------
using ReadFunction = std::function<void(const std::string&, FileContents&)>;

const std::map<std::string, ReadFunction>& Types()
{
  static const std::map<std::string, ReadFunction> types = {
    { ".3ds", Read3ds },
    { ".bmp", ReadData<vtkBMPReader> },
    { ".byu", ReadByu },
    { ".dem", ReadDem },
    { ".e", ReadExodus },
    { ".ex2", ReadExodus },
    { ".exo", ReadExodus },
    { ".glb", ReadGltf },
    { ".gltf", ReadGltf },
    { ".hdr", ReadHdr },
    { ".jpeg", ReadData<vtkJPEGReader> },
    { ".jpg", ReadData<vtkJPEGReader> },
    { ".mha", ReadImage<vtkMetaImageReader> },
    { ".mhd", ReadImage<vtkMetaImageReader> },
    { ".nhdr", ReadNrrd },
    { ".nii", ReadImage<vtkNIFTIImageReader> },
    { ".nrrd", ReadNrrd },
    { ".obj", ReadObj },
    { ".pgm", ReadPnm },
    { ".ply", ReadPly },
    { ".png", ReadPng },
    { ".ppm", ReadPnm },
    { ".pvd", ReadSeries },
    { ".pvti", ReadXml<vtkXMLPImageDataReader> },
    { ".pvtp", ReadXml<vtkXMLPPolyDataReader> },
    { ".pvtr", ReadXml<vtkXMLPRectilinearGridReader> },
    { ".pvts", ReadXml<vtkXMLPStructuredGridReader> },
    { ".pvtu", ReadXml<vtkXMLPUnstructuredGridReader> },
    { ".series", ReadSeries },
    { ".stl", ReadStl },
    { ".tif", ReadTiff },
    { ".tiff", ReadTiff },
    { ".vti", ReadXml<vtkXMLImageDataReader> },
    { ".vtk", ReadData<vtkGenericDataObjectReader> },
    { ".vtm", ReadXml<vtkXMLMultiBlockDataReader> },
    { ".vtmb", ReadXml<vtkXMLMultiBlockDataReader> },
    { ".vtp", ReadXml<vtkXMLPolyDataReader> },
    { ".vtpc", ReadXml<vtkXMLPartitionedDataSetCollectionReader> },
    { ".vtpd", ReadXml<vtkXMLPartitionedDataSetReader> },
    { ".vtr", ReadXml<vtkXMLRectilinearGridReader> },
    { ".vts", ReadXml<vtkXMLStructuredGridReader> },
    { ".vtu", ReadXml<vtkXMLUnstructuredGridReader> },
  };
  return types;
}

//------------------------------------------------------------------------------
std::string GetExtension(const std::string& path)
{
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  const bool isNifti = extension == ".gz" && GetExtension(fs::path(path).stem().string()) == ".nii";
  return isNifti ? ".nii" : extension; // which its reader unpacks
}

//------------------------------------------------------------------------------
const ReadFunction& CheckFile(const std::string& path)
{
  if (path.empty())
  {
    throw Failure("a file's name is empty; name the file, or leave it out");
  }
  CheckRegular(path);
  const std::string extension = GetExtension(path);
  const auto type = Types().find(extension);
  if (extension == ".gz" || extension == ".bz2" || extension == ".xz" || extension == ".zip")
  {
    throw Failure(path + ": is packed; unpack it first, as with gunzip or unzip");
  }
  if (type == Types().end())
  {
    throw Failure(path + ": is of an unknown type; give one of " + GetExtensions());
  }
  return type->second;
}

//------------------------------------------------------------------------------
void ReadPart(FileContents& contents)
{
  CheckFile(contents.Path)(contents.Path, contents);
}

//------------------------------------------------------------------------------
/**
 * Why a file could not be read. Some readers only warn when data are missing, and MetaIO just
 * prints it.
 */
std::string FindError(const Messages& messages)
{
  for (const std::string& error : messages.GetErrors())
  {
    // SimplifyMaterial() removes the textures that the one is about; the other is of data without points.
    if (error.find("texture is not in linear color space") == std::string::npos &&
      error.find("No Points element available") == std::string::npos)
    {
      return error;
    }
  }
  for (const std::string& warning : messages.GetWarnings())
  {
    if (warning.find("rror reading") != std::string::npos ||
      warning.find("File operation failed") != std::string::npos)
    {
      return warning;
    }
  }
  const bool cutOff = messages.GetPrinted().find("not read completely") != std::string::npos;
  return cutOff ? "its data end too early" : "";
}

//------------------------------------------------------------------------------
void RemoveEmpty(FileContents& contents)
{
  const auto noPoints = [](const auto& dataSet) { return dataSet->GetNumberOfPoints() == 0; };
  auto& dataSets = contents.DataSets;
  dataSets.erase(std::remove_if(dataSets.begin(), dataSets.end(), noPoints), dataSets.end());
}
}

//------------------------------------------------------------------------------
FileContents ReadFile(const std::string& path, std::optional<double> time)
{
  const ReadFunction& read = CheckFile(path);
  FileContents contents;
  contents.Path = path;
  contents.Time = time;
  const std::string remedy = "; the file is damaged, or not what its name says: write it again";
  std::string reason;
  try
  {
    const Messages messages(true, "godrays: " + path + ": cannot be read" + remedy, Failure::File);
    read(path, contents);
    reason = FindError(messages);
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::exception& exception)
  {
    reason = exception.what();
  }
  if (!reason.empty())
  {
    throw Failure(path + ": cannot be read (" + reason + ")" + remedy);
  }
  RemoveEmpty(contents);
  if (contents.DataSets.empty() && contents.Actors.empty())
  {
    throw Failure(path + ": holds nothing to draw; give a file with points and cells");
  }
  return contents;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadPicture(const std::string& option, const std::string& path)
{
  try
  {
    const FileContents contents = ReadFile(path, {});
    if (auto* image = contents.DataSets.empty()
        ? nullptr
        : vtkImageData::SafeDownCast(contents.DataSets.front()))
    {
      return image;
    }
  }
  catch (const Failure& failure)
  {
    throw Failure(option + ": " + failure.what(), Failure::File);
  }
  throw Failure(option + ": " + path + ": is no picture; give one", Failure::File);
}

//------------------------------------------------------------------------------
std::string GetExtensions()
{
  std::string list;
  for (const auto& [extension, read] : Types())
  {
    list += (list.empty() ? "" : " ") + extension;
  }
  return list;
}
