// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What of a file is looked at before a reader of VTK's, which would not end, or crash. Each throws Failure,
 * with what to do, where the file is not good for that reader.
 */

#ifndef FileChecks_h
#define FileChecks_h

#include <string> // For std::string

/**
 * Any file is regular, may be read, and has something in it. This holds for files that another file or an
 * option names, too.
 */
void CheckRegular(const std::string& path);

/// Checks the files that a file of VTK names: those of its pieces and blocks, and of theirs.
void CheckXmlParts(const std::string& path);

/**
 * VTK's XML readers give a name to each number of a tuple, and take hours for as many as a damaged file
 * may say.
 */
void CheckXml(const std::string& path);

/// Of .stl, VTK reads what there is of a binary file that was cut off.
void CheckStl(const std::string& path);

/// Of .3ds, VTK reads as far as the file says, past its end: for hours, if that is damaged.
void Check3ds(const std::string& path);

/// Of .nrrd, VTK reads for ever in a header without an end, without the number of its sizes, or with files
/// counted in steps of 0.
void CheckNrrd(const std::string& path);

/// Of .byu, VTK reads for ever where polygons do not end.
void CheckByu(const std::string& path);

/// Refuses a PNG that was cut off, whatever its name is: VTK ends the program there.
void CheckPng(const std::string& path);

/// Of .pnm and its like, VTK reads for ever in a header that ends.
void CheckPnm(const std::string& path);

/// Of .hdr, VTK takes memory for a size that is not there.
void CheckHdr(const std::string& path);

#endif
