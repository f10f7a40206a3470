// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What was measured, and how it is told: a file of comma-separated values, tables in Markdown, and
// the figures that are asked for, each met or missed.

#ifndef Report_h
#define Report_h

#include "Scattering.h"
#include "Statistics.h"

#include <string>
#include <vector>

/// The medians of one method on one case.
struct Record
{
  std::string Section;
  std::string Picture;
  std::string Light;
  bool OnScreen = true;
  std::string Method;
  int Channels = 1;
  int Width = 0;
  int Height = 0;
  int Samples = 100; // NumberOfSamples of the model
  int Threads = 0;   // of vtkSMPTools; 0: as it is by itself
  double Milliseconds = Statistics::None;
  double Copies = Statistics::None;  // of a full-screen copy
  double Marches = Statistics::None; // of the bare march of 60 taps
  double Gain = Statistics::None;    // the customary method's time over this one's
  bool HasErrors = false;
  Errors Error;
};

/// A figure that is asked for.
struct Figure
{
  enum Relation
  {
    AT_MOST,
    AT_LEAST
  };
  std::string Text;
  Relation Relates = AT_MOST;
  double Bound = 0.0;
  double Measured = Statistics::None; // None: not measured
  std::string Note;

  bool IsMeasured() const;
  bool IsMet() const;
};

/// A table of figures in Markdown, each met or missed.
std::string MakeFigureTable(const std::vector<Figure>& figures);

class Report
{
public:
  std::string Renderer;     // what OpenGL calls itself
  std::string Instructions; // the processor's vector instructions
  int Width = 0;            // of the cases
  int Height = 0;
  int Rows = 0; // that are compared with the reference, for each case
  std::vector<Record> Records;
  std::vector<Figure> Figures;

  /// The values of the records of a method in a section.
  std::vector<double> Get(const std::string& section, const std::string& method, int channels,
    double (*value)(const Record&)) const;
  /// Names of the methods of a section, in the order in which they were measured.
  std::vector<std::string> GetMethods(const std::string& section) const;

  /// Tables and figures in Markdown.
  std::string MakeTables() const;

  void WriteCSV(const std::string& file) const;

  /// A page of documentation, with the charts that stand in a folder beside it.
  void WritePage(const std::string& file, const std::string& command) const;
};

/**
 * End a page with a digest of its text and of the pictures that it shows, as far as they are there.
 * .ci/check-tree makes it again: what another run wrote, or a hand, is found.
 */
void SealPage(const std::string& file);

/// Values of records, for Get().
double GetRMS(const Record& record);
double GetPermille(const Record& record);
double GetLargestError(const Record& record);
double GetBias(const Record& record);
double GetCopies(const Record& record);
double GetMarches(const Record& record);
double GetGain(const Record& record);
double GetMilliseconds(const Record& record);

#endif
