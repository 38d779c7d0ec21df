// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankGathering.h"

#include "KernelExecutor.h"
#include "PieceMerging.h"

#include "vtkAlgorithm.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTypes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <new>

namespace sbvtk
{
namespace
{

constexpr int tag = 81027;
constexpr vtkIdType longestMessage = vtkIdType{ 1 } << 30; ///< MPI counts in 32 bits
constexpr std::int64_t root = -1; ///< place of what belongs to composite data as a whole

/** A place of composite data and what is there. */
using Leaf = std::pair<std::int64_t, vtkDataObject*>;

/** Partitions of a collection count by their data set: processes may have different numbers of
 * them. */
std::vector<Leaf> LeavesOf(vtkDataObject* data)
{
  std::vector<Leaf> leaves;
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
    {
      for (unsigned int j = 0; j < collection->GetNumberOfPartitions(i); ++j)
      {
        leaves.emplace_back(
          (std::int64_t{ i } << 32) + j, collection->GetPartitionAsDataObject(i, j));
      }
    }
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      leaves.emplace_back(iterator->GetCurrentFlatIndex(), iterator->GetCurrentDataObject());
    }
  }
  else
  {
    leaves.emplace_back(0, data);
  }
  leaves.erase(
    std::remove_if(leaves.begin(), leaves.end(), [](const Leaf& leaf) { return !leaf.second; }),
    leaves.end());
  return leaves;
}

std::vector<vtkMTimeType> StampOf(vtkDataObject* data)
{
  std::vector<vtkMTimeType> stamp;
  for (const Leaf& leaf : LeavesOf(data))
  {
    stamp.push_back(static_cast<vtkMTimeType>(leaf.first));
    stamp.push_back(leaf.second->GetMTime());
  }
  if (data)
  {
    stamp.push_back(data->GetFieldData()->GetMTime());
  }
  return stamp;
}

/** All of a leaf that travels. */
Piece PieceOf(const Leaf& leaf)
{
  Piece piece;
  piece.Place = leaf.first;
  piece.Type = leaf.second->GetDataObjectType();
  piece.Data = vtkPolyData::SafeDownCast(leaf.second);
  if (!piece.Data)
  {
    piece.Data = vtkSmartPointer<vtkPolyData>::New();
    piece.Data->SetFieldData(leaf.second->GetFieldData());
    if (vtkPointSet* cloud = vtkPointSet::SafeDownCast(leaf.second))
    {
      piece.Data->SetPoints(cloud->GetPoints());
      piece.Data->GetPointData()->ShallowCopy(cloud->GetPointData());
    }
  }
  piece.Data = WithoutGhosts(piece.Data);
  return piece;
}

std::vector<Piece> PiecesOf(vtkDataObject* data)
{
  std::vector<Piece> pieces;
  for (const Leaf& leaf : LeavesOf(data))
  {
    pieces.push_back(PieceOf(leaf));
  }
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    Piece whole;
    whole.Place = root;
    whole.Data = vtkSmartPointer<vtkPolyData>::New();
    whole.Data->SetFieldData(data->GetFieldData());
    pieces.push_back(whole);
  }
  return pieces;
}

/** The merged pieces of one place as the type that they had. */
vtkSmartPointer<vtkDataObject> AsType(int type, vtkPolyData* merged)
{
  if (type == VTK_POLY_DATA)
  {
    return merged;
  }
  const auto object = vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type));
  object->SetFieldData(merged->GetFieldData());
  if (vtkPointSet* cloud = vtkPointSet::SafeDownCast(object))
  {
    cloud->SetPoints(merged->GetPoints());
    cloud->GetPointData()->ShallowCopy(merged->GetPointData());
  }
  return object;
}

/** A composite data set of the structure and with the names of `own`, and these leaves. */
vtkSmartPointer<vtkDataObject> Composite(
  vtkCompositeDataSet* own, const std::map<std::int64_t, vtkSmartPointer<vtkDataObject>>& leaves)
{
  const auto whole = vtkSmartPointer<vtkCompositeDataSet>::Take(own->NewInstance());
  if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(whole))
  {
    collection->CopyStructure(own);
    for (const auto& leaf : leaves)
    {
      collection->SetPartition(static_cast<unsigned int>(leaf.first >> 32),
        static_cast<unsigned int>(leaf.first & 0xffffffff), leaf.second);
    }
  }
  else if (auto* parts = vtkPartitionedDataSet::SafeDownCast(whole))
  {
    for (const auto& leaf : leaves)
    {
      parts->SetPartition(parts->GetNumberOfPartitions(), leaf.second);
    }
  }
  else
  {
    whole->CopyStructure(own);
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(whole->NewIterator());
    iterator->SkipEmptyNodesOff();
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      const auto leaf = leaves.find(iterator->GetCurrentFlatIndex());
      if (leaf != leaves.end())
      {
        whole->SetDataSet(iterator, leaf->second);
      }
    }
  }
  return whole;
}

/** Pieces of all processes, those of one place in the order of the processes. `own` has the
 * structure of them. */
vtkSmartPointer<vtkDataObject> Together(const std::vector<Piece>& pieces, vtkDataObject* own)
{
  std::map<std::int64_t, std::vector<vtkSmartPointer<vtkPolyData>>> places;
  std::map<std::int64_t, int> types;
  for (const Piece& piece : pieces)
  {
    places[piece.Place].push_back(piece.Data);
    types.emplace(piece.Place, piece.Type);
  }
  KernelExecutor executor;
  std::map<std::int64_t, vtkSmartPointer<vtkDataObject>> leaves;
  for (const auto& place : places)
  {
    leaves[place.first] = AsType(types[place.first], MergePieces(place.second, executor));
  }
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(own);
  if (!composite)
  {
    return leaves.empty() ? nullptr : leaves.begin()->second;
  }
  const vtkSmartPointer<vtkDataObject> fields = leaves[root];
  leaves.erase(root);
  const vtkSmartPointer<vtkDataObject> whole = Composite(composite, leaves);
  whole->SetFieldData(fields->GetFieldData());
  return whole;
}

} // namespace

//------------------------------------------------------------------------------
RankGathering::RankGathering()
  : RankGathering(vtkMultiProcessController::GetGlobalController())
{
}

//------------------------------------------------------------------------------
RankGathering::RankGathering(vtkMultiProcessController* controller)
  : Controller(controller)
{
}

//------------------------------------------------------------------------------
RankGathering::~RankGathering() = default;

//------------------------------------------------------------------------------
void RankGathering::SetController(vtkMultiProcessController* controller)
{
  this->Controller = controller;
  this->Connections.clear();
  this->LastNews = {};
}

//------------------------------------------------------------------------------
int RankGathering::Rank() const
{
  return this->Controller ? this->Controller->GetLocalProcessId() : 0;
}

//------------------------------------------------------------------------------
int RankGathering::NumberOfRanks() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

//------------------------------------------------------------------------------
bool RankGathering::IsParallel() const { return this->NumberOfRanks() > 1; }

//------------------------------------------------------------------------------
void RankGathering::RequestPieces(vtkInformationVector** inputs, int numberOfPorts) const
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < numberOfPorts; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* input = inputs[port]->GetInformationObject(i);
      input->Set(Pipeline::UPDATE_PIECE_NUMBER(), this->Rank());
      input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), this->NumberOfRanks());
      input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
}

//------------------------------------------------------------------------------
bool RankGathering::InAll(bool condition) const
{
  const int own = condition ? 1 : 0;
  int all = own;
  if (this->IsParallel())
  {
    this->Controller->AllReduce(&own, &all, 1, vtkCommunicator::MIN_OP);
  }
  return all != 0;
}

//------------------------------------------------------------------------------
void RankGathering::TryInAll(const std::function<void()>& work) const
{
  bool fits = true;
  try
  {
    work();
  }
  catch (const std::bad_alloc&)
  {
    fits = false;
  }
  if (!this->InAll(fits))
  {
    throw std::bad_alloc();
  }
}

//------------------------------------------------------------------------------
std::int64_t RankGathering::Sum(std::int64_t value) const
{
  const long long own = value;
  long long sum = own;
  if (this->IsParallel())
  {
    this->Controller->AllReduce(&own, &sum, 1, vtkCommunicator::SUM_OP);
  }
  return sum;
}

//------------------------------------------------------------------------------
std::vector<std::vector<char>> RankGathering::Collect(const std::vector<char>& bytes) const
{
  const auto count = static_cast<std::size_t>(this->NumberOfRanks());
  const long long own = static_cast<long long>(bytes.size());
  std::vector<long long> sizes(count, own);
  this->Controller->AllGather(&own, sizes.data(), 1);
  std::vector<std::vector<char>> all(this->IsFirst() ? count : 0);
  this->TryInAll([&] {
    for (std::size_t rank = 0; rank < all.size(); ++rank)
    {
      all[rank].resize(static_cast<std::size_t>(sizes[rank]));
    }
  });
  for (std::size_t rank = 0; rank < all.size(); ++rank)
  {
    if (rank == 0)
    {
      all[rank] = bytes;
    }
    for (vtkIdType at = 0; rank > 0 && at < sizes[rank]; at += longestMessage)
    {
      this->Controller->Receive(all[rank].data() + at,
        std::min<vtkIdType>(longestMessage, sizes[rank] - at), static_cast<int>(rank), tag);
    }
  }
  for (vtkIdType at = 0; !this->IsFirst() && at < own; at += longestMessage)
  {
    this->Controller->Send(
      bytes.data() + at, std::min<vtkIdType>(longestMessage, own - at), 0, tag);
  }
  return all;
}

//------------------------------------------------------------------------------
void RankGathering::Distribute(std::vector<char>& bytes) const
{
  long long size = static_cast<long long>(bytes.size());
  this->Controller->Broadcast(&size, 1, 0);
  this->TryInAll([&] { bytes.resize(static_cast<std::size_t>(size)); });
  for (vtkIdType at = 0; at < size; at += longestMessage)
  {
    this->Controller->Broadcast(
      bytes.data() + at, std::min<vtkIdType>(longestMessage, size - at), 0);
  }
}

//------------------------------------------------------------------------------
void RankGathering::DistributeFirstOf(std::vector<char>& bytes) const
{
  const std::vector<std::vector<char>> all = this->Collect(bytes);
  const auto first = std::find_if(
    all.begin(), all.end(), [](const std::vector<char>& ofRank) { return !ofRank.empty(); });
  bytes = first == all.end() ? std::vector<char>() : *first;
  this->Distribute(bytes);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> RankGathering::Gather(
  vtkDataObject* own, int port, int connection, Receiver receiver)
{
  if (!this->IsParallel())
  {
    return own;
  }
  Kept& kept = this->Connections[{ port, connection }];
  std::vector<vtkMTimeType> stamp = StampOf(own);
  if (this->InAll(!kept.Stamp.empty() && stamp == kept.Stamp))
  {
    return kept.Whole;
  }
  kept = {};
  std::vector<Piece> pieces;
  std::vector<char> bytes;
  this->TryInAll([&] {
    pieces = PiecesOf(own);
    if (!this->IsFirst())
    {
      PackPieces(pieces, PieceContents::All, bytes);
    }
  });
  std::vector<std::vector<char>> received = this->Collect(bytes);
  std::vector<char>().swap(bytes);
  this->TryInAll([&] {
    for (std::vector<char>& ofRank : received)
    {
      const std::vector<Piece> others = UnpackPieces(ofRank);
      pieces.insert(pieces.end(), others.begin(), others.end());
      std::vector<char>().swap(ofRank);
    }
    if (this->IsFirst())
    {
      kept.Whole = Together(pieces, own);
      if (receiver == Receiver::All)
      {
        PackPieces(PiecesOf(kept.Whole), PieceContents::All, bytes);
      }
    }
  });
  if (receiver == Receiver::All)
  {
    this->Distribute(bytes);
    this->TryInAll([&] {
      if (!this->IsFirst())
      {
        kept.Whole = Together(UnpackPieces(bytes), own);
      }
    });
  }
  kept.Stamp = std::move(stamp);
  return kept.Whole;
}

//------------------------------------------------------------------------------
WholeInputs RankGathering::Gather(vtkInformationVector** inputs, int numberOfPorts)
{
  WholeInputs whole;
  for (int port = 0; port < numberOfPorts; ++port)
  {
    const auto vector = vtkSmartPointer<vtkInformationVector>::New();
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkNew<vtkInformation> input;
      input->Copy(inputs[port]->GetInformationObject(i));
      const vtkSmartPointer<vtkDataObject> data =
        this->Gather(vtkDataObject::GetData(inputs[port], i), port, i, Receiver::First);
      input->Set(vtkDataObject::DATA_OBJECT(), data);
      vector->Append(input);
    }
    whole.Vectors.push_back(vector);
    whole.Pointers.push_back(vector);
  }
  return whole;
}

//------------------------------------------------------------------------------
bool RankGathering::IsNews(vtkAlgorithm* filter, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const std::pair<vtkMTimeType, double> now{
    Pipeline::SafeDownCast(filter->GetExecutive())->GetPipelineMTime(),
    output->Has(Pipeline::UPDATE_TIME_STEP()) ? output->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0
  };
  const bool isNews = now != this->LastNews;
  this->LastNews = now;
  return isNews;
}

//------------------------------------------------------------------------------
void RankGathering::Keep(vtkInformationVector* outputs)
{
  this->LastOutputs.clear();
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    this->LastOutputs.push_back(vtkSmartPointer<vtkDataObject>::Take(output->NewInstance()));
    this->LastOutputs.back()->ShallowCopy(output);
  }
}

//------------------------------------------------------------------------------
void RankGathering::Restore(vtkInformationVector* outputs) const
{
  for (std::size_t port = 0; port < this->LastOutputs.size(); ++port)
  {
    vtkDataObject::GetData(outputs, static_cast<int>(port))->ShallowCopy(this->LastOutputs[port]);
  }
}

//------------------------------------------------------------------------------
void RankGathering::ShareArrays(vtkPolyData* surface) const
{
  std::vector<char> bytes;
  if (this->IsFirst())
  {
    PackPieces({ { 0, VTK_POLY_DATA, surface } }, PieceContents::OnlyArrays, bytes);
  }
  this->Distribute(bytes);
  if (!this->IsFirst())
  {
    surface->ShallowCopy(UnpackPieces(bytes).front().Data);
  }
}

//------------------------------------------------------------------------------
void RankGathering::MoveToFirst(vtkPolyData* surface)
{
  const vtkSmartPointer<vtkDataObject> whole =
    RankGathering(this->Controller).Gather(surface, 0, 0, Receiver::First);
  if (this->IsFirst())
  {
    surface->ShallowCopy(whole);
  }
  this->ShareArrays(surface);
}

//------------------------------------------------------------------------------
void RankGathering::ShareArraysWithEmpty(vtkPolyData* surface) const
{
  std::vector<char> bytes;
  if (surface->GetNumberOfPoints() > 0)
  {
    PackPieces({ { 0, VTK_POLY_DATA, surface } }, PieceContents::OnlyArrays, bytes);
  }
  this->DistributeFirstOf(bytes);
  if (surface->GetNumberOfPoints() == 0 && !bytes.empty())
  {
    surface->ShallowCopy(UnpackPieces(bytes).front().Data);
  }
}

} // namespace sbvtk
