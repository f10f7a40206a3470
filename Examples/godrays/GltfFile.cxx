// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GltfFile.h"

#include "Failure.h"
#include "FileChecks.h"
#include "Json.h"
#include "System.h"

#include "vtkVersionMacros.h"
#include "vtksys/SystemTools.hxx"

#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

namespace
{
namespace fs = std::filesystem;

constexpr std::size_t GlbHeader = 12;
constexpr std::size_t ChunkHeader = 8;

/// A picture of one white pixel.
constexpr const char* WhitePicture =
  "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR42mP4//8/AAX+Av4z"
  "EpUUAAAAAElFTkSuQmCC";

//------------------------------------------------------------------------------
std::string Escape(const std::string& plain)
{
  std::string text;
  for (const char letter : plain)
  {
    text += letter == '"' || letter == '\\' ? std::string("\\") + letter : std::string(1, letter);
  }
  return text;
}

//------------------------------------------------------------------------------
/// What names a file in a URI: RFC 3986, section 2.1, of all but unreserved characters and slashes.
[[maybe_unused]] std::string EncodePercents(const std::string& path)
{
  constexpr const char* digits = "0123456789ABCDEF";
  std::string uri;
  for (const char each : path)
  {
    const auto byte = static_cast<unsigned char>(each);
    if (std::isalnum(byte) != 0 || std::string_view("-._~/").find(each) != std::string_view::npos)
    {
      uri += each;
    }
    else
    {
      uri += { '%', digits[byte / 16], digits[byte % 16] };
    }
  }
  return uri;
}

//------------------------------------------------------------------------------
/// How VTK's importer is told of a file: by its URI since VTK 9.3, and by its path before.
std::string NameToRead(const std::string& path)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return EncodePercents(path);
#else
  return path;
#endif
}

//------------------------------------------------------------------------------
std::uint32_t GetNumber(const std::string& bytes, std::size_t position)
{
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;)
  {
    const char byte = position + i < bytes.size() ? bytes[position + i] : '\0';
    number = number << 8 | static_cast<unsigned char>(byte);
  }
  return number;
}

//------------------------------------------------------------------------------
void SetNumber(std::string& bytes, std::size_t position, std::size_t number)
{
  for (std::size_t i = 0; i < 4; ++i)
  {
    bytes[position + i] = static_cast<char>(number >> 8 * i & 0xff);
  }
}

//------------------------------------------------------------------------------
void CheckVersion(const std::string& path, std::string_view version)
{
  if (!version.empty() && version.front() == '1')
  {
    throw Failure(path + ": is glTF 1, and VTK reads glTF 2; convert it, as with gltf-pipeline");
  }
}

//------------------------------------------------------------------------------
void CheckExtensions(const std::string& path, const std::vector<JsonMember>& document)
{
  const std::pair<const char*, const char*> unknown[] = { { "KHR_draco_mesh_compression", "Draco" },
    { "EXT_meshopt_compression", "meshopt" } };
  for (const JsonMember& required : SplitJson(FindJson(document, "extensionsRequired")))
  {
    for (const auto& [extension, name] : unknown)
    {
      if (UnquoteJson(required.Value) == extension)
      {
        throw Failure(path + ": is compressed with " + name + " (" + extension +
          "), which VTK cannot read; save it without compression");
      }
    }
  }
}
}

//------------------------------------------------------------------------------
GltfFile::GltfFile(const std::string& path)
  : Path(path)
  , PathToRead(path)
{
  std::ifstream file(path, std::ios::binary);
  std::string header(GlbHeader + ChunkHeader, '\0');
  file.read(header.data(), static_cast<std::streamsize>(header.size()));
  if (header.rfind("glTF", 0) == 0)
  {
    CheckVersion(path, std::to_string(GetNumber(header, 4)));
    const std::uintmax_t size = fs::file_size(path);
    this->Rest = header.size() + static_cast<std::size_t>(GetNumber(header, GlbHeader));
    if (GetNumber(header, 8) > size || this->Rest > size)
    {
      throw Failure(path + ": is shorter than it says; copy it again");
    }
    this->Json.resize(this->Rest - header.size());
    file.read(this->Json.data(), static_cast<std::streamsize>(this->Json.size()));
  }
  else
  {
    file.clear();
    file.seekg(0);
    this->Json.assign(std::istreambuf_iterator<char>(file), {});
  }
  const std::vector<JsonMember> document = SplitJson(this->Json);
  CheckVersion(path, UnquoteJson(FindJson(SplitJson(FindJson(document, "asset")), "version")));
  CheckVersion(path, FindJson(document, "meshes").rfind('{', 0) == 0 ? "1" : "2");
  CheckExtensions(path, document);
  this->ReplaceUris();
}

//------------------------------------------------------------------------------
GltfFile::~GltfFile() = default; // the copy goes before its folder

//------------------------------------------------------------------------------
/**
 * Name the files beside this one such that a copy elsewhere finds them. Pictures that are missing
 * become white.
 */
void GltfFile::ReplaceUris()
{
  std::string json;
  std::size_t copied = 0;
  bool change = false;
  for (const JsonMember& list : SplitJson(this->Json))
  {
    const bool ofPictures = list.Name == "images";
    if (!ofPictures && list.Name != "buffers")
    {
      continue;
    }
    for (const JsonMember& each : SplitJson(list.Value))
    {
      const std::string_view text = UnquoteJson(FindJson(SplitJson(each.Value), "uri"));
      if (text.empty() || text.rfind("data:", 0) == 0)
      {
        continue;
      }
      std::error_code ignored;
      const std::string uri = UnescapeJson(text);
      const fs::path folder = fs::absolute(this->Path, ignored).parent_path();
      fs::path file = folder / uri;
      change = change || !fs::exists(file, ignored) || NameToRead(uri) != uri;
      if (!fs::exists(file, ignored))
      {
        file = folder / vtksys::SystemTools::DecodeURL(uri);
      }
      const bool isMissing = !fs::exists(file, ignored);
      if (isMissing && !ofPictures)
      {
        throw Failure(this->Path + ": its buffer " + uri + " is missing; put it there");
      }
      if (!isMissing)
      {
        CheckRegular(file.string());
        CheckPng(file.string());
        const std::string bytes(FindJson(SplitJson(each.Value), "byteLength"));
        if (std::strtod(bytes.c_str(), nullptr) > static_cast<double>(fs::file_size(file)))
        {
          throw Failure(file.string() + ": is shorter than " + this->Path + " says; copy it again");
        }
      }
      if (isMissing)
      {
        this->MissingPictures.push_back(uri);
      }
      const auto begin = static_cast<std::size_t>(text.data() - this->Json.data());
      json += this->Json.substr(copied, begin - copied);
      json += isMissing ? WhitePicture : Escape(NameToRead(file.string()));
      copied = begin + text.size();
    }
  }
  if (change)
  {
    this->Json = json + this->Json.substr(copied);
    this->WriteCopy();
  }
}

//------------------------------------------------------------------------------
void GltfFile::WriteCopy()
{
  const std::string folder = System::MakeTemporaryFolder();
  if (folder.empty())
  {
    throw Failure(this->Path +
      ": pictures are missing, and there is no folder for a copy without "
      "them; set TMPDIR to one that may be written");
  }
  this->Folder.emplace(folder);
  this->PathToRead = (fs::path(folder) / fs::path(this->Path).filename()).string();
  this->Copy.emplace(this->PathToRead);
  std::ofstream copy(this->PathToRead, std::ios::binary);
  const auto check = [&]
  {
    if (!copy.flush())
    {
      throw Failure(this->Path + ": pictures are missing, and a copy without them in " + folder +
        " could not be written; is the disk full?");
    }
  };
  if (this->Rest == 0)
  {
    copy << this->Json;
    check();
    return;
  }
  std::ifstream file(this->Path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(this->Rest));
  this->Json.resize((this->Json.size() + 3) / 4 * 4, ' ');
  std::string header("glTF\2\0\0\0\0\0\0\0\0\0\0\0JSON", GlbHeader + ChunkHeader);
  const std::uintmax_t rest = fs::file_size(this->Path) - this->Rest;
  SetNumber(header, 8, header.size() + this->Json.size() + rest);
  SetNumber(header, GlbHeader, this->Json.size());
  copy << header << this->Json;
  if (rest > 0)
  {
    copy << file.rdbuf();
  }
  check();
}
