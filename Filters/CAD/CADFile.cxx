// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CADFile.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <Bnd_Box.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message_ProgressScope.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <XSControl_Reader.hxx>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace sbvtk
{
namespace
{

bool IsIGES(const std::string& name)
{
  std::string ending = name.substr(std::min(name.size(), name.find_last_of('.') + 1));
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == "igs" || ending == "iges";
}

std::string Transfer(XSControl_Reader& reader, const std::string& name, TopoDS_Shape& shape,
  const Message_ProgressRange& progress)
{
  if (reader.ReadFile(name.c_str()) != IFSelect_RetDone)
  {
    return "is no STEP or IGES file that can be read, or is damaged; export it again.";
  }
  reader.TransferRoots(progress);
  shape = reader.OneShape();
  return "";
}

/** A file beside the one to be written, so that there is never half of one: not where writing fails
 * and not where it is stopped. */
class UnfinishedFile
{
public:
  explicit UnfinishedFile(const std::string& name)
    : Final(name)
    , Unfinished(name + ".part")
  {
  }
  ~UnfinishedFile()
  {
    std::error_code ignored;
    std::filesystem::remove(this->Unfinished, ignored);
  }
  UnfinishedFile(const UnfinishedFile&) = delete;
  void operator=(const UnfinishedFile&) = delete;

  const std::string& Name() const { return this->Unfinished; }

  bool Finish() const
  {
    std::error_code failure;
    std::filesystem::rename(this->Unfinished, this->Final, failure);
    return !failure;
  }

private:
  std::string Final;
  std::string Unfinished;
};

/** Whether some faces are in no shell. */
bool HasLooseFaces(const TopoDS_Shape& shape)
{
  return TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SHELL).More();
}

/** Edges that lie at most so far apart are made one; the least distance of these that joins the
 * most is taken, since a larger one would close gaps that are meant. */
TopoDS_Shape Sewn(const TopoDS_Shape& shape, const Message_ProgressRange& progress)
{
  constexpr double shares[] = { 1e-6, 1e-5, 1e-4 }; // of the diagonal
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  const double diagonal = std::sqrt(box.SquareExtent());
  Message_ProgressScope scope(progress, "", 3);
  TopoDS_Shape best = shape;
  int fewestFree = -1;
  for (const double share : shares)
  {
    BRepBuilderAPI_Sewing sewing(share * diagonal);
    sewing.Add(shape);
    sewing.Perform(scope.Next());
    if (fewestFree < 0 || sewing.NbFreeEdges() < fewestFree)
    {
      fewestFree = sewing.NbFreeEdges();
      best = sewing.SewedShape();
    }
    if (fewestFree == 0 || scope.UserBreak())
    {
      break;
    }
  }
  return best;
}

} // namespace

std::string ReadCADFile(const std::string& name, TopoDS_Shape& shape, PartNames& parts,
  const Message_ProgressRange& progress)
{
  shape.Nullify();
  if (!std::ifstream(name))
  {
    return "cannot be opened; check its name and your rights.";
  }
  Message_ProgressScope scope(progress, "", 2);
  std::string refusal;
  if (IsIGES(name))
  {
    IGESControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    refusal = Transfer(reader, name, shape, scope.Next());
  }
  else
  {
    STEPControl_Reader reader;
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
    refusal = Transfer(reader, name, shape, scope.Next());
    if (refusal.empty())
    {
      parts = FindPartNames(reader, shape);
    }
  }
  if (refusal.empty() && !shape.IsNull() && scope.More() && HasLooseFaces(shape))
  {
    shape = Sewn(shape, scope.Next());
  }
  return refusal;
}

std::string WriteSTEPFile(
  const std::string& name, const TopoDS_Shape& shape, const Message_ProgressRange& progress)
{
  std::error_code ignored;
  const bool exists = std::filesystem::exists(name, ignored);
  const UnfinishedFile unfinished(name);
  if (!std::ofstream(unfinished.Name()) || (exists && !std::ofstream(name, std::ios::app)))
  {
    return "cannot be written; check its folder and your rights.";
  }
  STEPControl_Writer writer;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetCVal("write.step.unit", "MM");
  if (writer.Transfer(shape, STEPControl_AsIs, Standard_True, progress) != IFSelect_RetDone ||
    writer.Write(unfinished.Name().c_str()) != IFSelect_RetDone || !unfinished.Finish())
  {
    return "could not be written; there may be no room for it.";
  }
  return "";
}

} // namespace sbvtk
