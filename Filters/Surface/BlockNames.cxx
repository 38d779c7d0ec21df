// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BlockNames.h"

#include "FieldArrays.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

namespace sbvtk
{
namespace
{

/** As ParaView calls a block without a name. */
template <class Tree>
std::string NameOf(Tree* tree, unsigned int number)
{
  const char* name = tree->HasMetaData(number)
    ? tree->GetMetaData(number)->Get(vtkCompositeDataSet::NAME())
    : nullptr;
  return name && *name ? name : "Block " + std::to_string(number);
}

class BlockList
{
public:
  explicit BlockList(Blocks& blocks)
    : Found(blocks)
  {
  }

  void Add(vtkDataObject* data, const std::string& path)
  {
    if (vtkMultiBlockDataSet* tree = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      for (unsigned int i = 0; i < tree->GetNumberOfBlocks(); ++i)
      {
        this->Add(tree->GetBlock(i), Joined(path, NameOf(tree, i)));
      }
    }
    else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
    {
      for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
      {
        this->Add(collection->GetPartitionedDataSet(i), Joined(path, NameOf(collection, i)));
      }
    }
    else
    {
      this->AddBlock(data, path);
    }
  }

private:
  static std::string Joined(const std::string& path, const std::string& name)
  {
    return path.empty() ? name : path + "/" + name;
  }

  /** Parts of one thing are one block. */
  void AddBlock(vtkDataObject* data, const std::string& path)
  {
    const int block = path.empty() ? -1 : static_cast<int>(this->Found.Names.size());
    if (block >= 0)
    {
      this->Found.Names.push_back(path);
    }
    vtkCompositeDataSet* parts = vtkCompositeDataSet::SafeDownCast(data);
    if (!parts)
    {
      this->AddLeaf(data, block);
      return;
    }
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(parts->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      this->AddLeaf(iterator->GetCurrentDataObject(), block);
    }
  }

  void AddLeaf(vtkDataObject* leaf, int block)
  {
    if (leaf)
    {
      this->Found.Leaves.push_back(leaf);
      this->Found.BlockOfLeaf.push_back(block);
    }
  }

  Blocks& Found;
};

} // namespace

//------------------------------------------------------------------------------
Blocks BlocksOf(vtkDataObject* data)
{
  Blocks blocks;
  BlockList(blocks).Add(data, "");
  return blocks;
}

//------------------------------------------------------------------------------
BlockNames CarriedBlockNames(vtkDataObject* data, vtkDataSetAttributes* attributes)
{
  vtkDataArray* numbers = attributes->GetArray(BlockArray);
  vtkStringArray* names =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(BlockNamesArray));
  if (!numbers || numbers->GetNumberOfComponents() != 1 || !names)
  {
    return {};
  }
  return BlockNames(names->GetPointer(0), names->GetPointer(0) + names->GetNumberOfValues());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkIntArray> NumbersFrom(int firstBlock, vtkDataSetAttributes* attributes)
{
  const auto numbers = vtkSmartPointer<vtkIntArray>::New();
  numbers->DeepCopy(attributes->GetArray(BlockArray));
  numbers->SetName(BlockArray);
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
  {
    int& number = numbers->GetPointer(0)[i];
    number += number >= 0 ? firstBlock : 0;
  }
  return numbers;
}

//------------------------------------------------------------------------------
void AddBlockNames(vtkDataObject* output, const BlockNames& names)
{
  if (!names.empty())
  {
    AddField<vtkStringArray>(output, BlockNamesArray, names);
  }
}

} // namespace sbvtk
