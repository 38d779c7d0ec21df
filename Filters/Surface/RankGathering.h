// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RankGathering.h
 * @brief What the processes of a parallel server have of a filter's inputs, brought together.
 *
 * Each process of a server has a piece of every data set. A surface's inside is a matter of all of
 * it, so a filter needs the pieces of all processes. Everything here is to be called by all
 * processes, in the same order; what goes wrong in one is thrown in all, so that none waits for
 * another for ever. Without a controller, or with one process, inputs are passed on as they are.
 */
#ifndef RankGathering_h
#define RankGathering_h

#include "PiecePacking.h"
#include "sbSurfaceModule.h" // for the export macro

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <map>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;

namespace sbvtk
{

/** The inputs of a filter as its RequestData has them. */
class WholeInputs
{
public:
  vtkInformationVector** Ports() { return this->Pointers.data(); }

private:
  friend class RankGathering;
  std::vector<vtkSmartPointer<vtkInformationVector>> Vectors;
  std::vector<vtkInformationVector*> Pointers;
};

class SBSURFACE_EXPORT RankGathering
{
public:
  /** Who has the whole after Gather. */
  enum class Receiver
  {
    First,
    All
  };

  /** Of the processes of ParaView's server. */
  RankGathering();
  explicit RankGathering(vtkMultiProcessController* controller);
  ~RankGathering();
  RankGathering(const RankGathering&) = delete;
  void operator=(const RankGathering&) = delete;

  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const { return this->Controller; }
  bool IsParallel() const;
  bool IsFirst() const { return this->Rank() == 0; }
  int Rank() const;
  int NumberOfRanks() const;

  /**
   * Ask all inputs for the piece of this process, without ghosts, whatever is asked for downstream:
   * filters such as Clean ask the first process for everything and the others for nothing, which
   * not every source follows.
   */
  void RequestPieces(vtkInformationVector** inputs, int numberOfPorts) const;

  /**
   * The data object of one connection, whole: of the receivers; the others get null. Blocks of
   * composite data are put together block by block. What did not change in any process since the
   * last call with the same port and connection is not sent again.
   * @throw std::bad_alloc in all processes if it does not fit into the memory of one
   */
  vtkSmartPointer<vtkDataObject> Gather(
    vtkDataObject* own, int port, int connection, Receiver receiver);

  /** The inputs for the first process, with all of their pieces. */
  WholeInputs Gather(vtkInformationVector** inputs, int numberOfPorts);

  /**
   * Whether the filter, what is before it, or the time has changed since the last call. Of that all
   * processes notice the same. Other reasons to execute are not shared: a filter downstream may ask
   * one process for another piece and leave the others alone.
   */
  bool IsNews(vtkAlgorithm* filter, vtkInformation* output);

  /** Remember the outputs, for an execution without news. */
  void Keep(vtkInformationVector* outputs);
  void Restore(vtkInformationVector* outputs) const;

  /** Let all other processes have the arrays and field data of the first one's surface, and no
   * points and cells. */
  void ShareArrays(vtkPolyData* surface) const;

  /** Let the first process have a surface's pieces of all processes, and the others its arrays. */
  void MoveToFirst(vtkPolyData* surface);

  /** Let the processes that have no points of a surface have the arrays of the first one that has
   * any. */
  void ShareArraysWithEmpty(vtkPolyData* surface) const;

  /** What the first process that gives any bytes gives, for all. */
  void DistributeFirstOf(std::vector<char>& bytes) const;

  /** What the first process gives, for all. */
  void Distribute(std::vector<char>& bytes) const;

  /** Whether it is true in all processes. */
  bool InAll(bool condition) const;

  /** Of the values of all processes. */
  std::int64_t Sum(std::int64_t value) const;

private:
  struct Kept
  {
    std::vector<vtkMTimeType> Stamp; ///< of this process's piece
    vtkSmartPointer<vtkDataObject> Whole;
  };

  /** Let each process do its work. @throw std::bad_alloc in all if one has no memory for it */
  void TryInAll(const std::function<void()>& work) const;

  /** What each process gives: for the first one, the others get nothing. */
  std::vector<std::vector<char>> Collect(const std::vector<char>& bytes) const;

  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::pair<vtkMTimeType, double> LastNews; ///< of the pipeline, and the time
  std::vector<vtkSmartPointer<vtkDataObject>> LastOutputs;
  std::map<std::pair<int, int>, Kept> Connections;
};

} // namespace sbvtk

#endif
