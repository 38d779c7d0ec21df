// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Replay.cxx
 * @brief Runs a fuzzer's function on every file of the folders, or on the files, that are named:
 * its corpus as a test, with any compiler.
 */
#include "Check.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

void Replay(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::vector<char> bytes{ std::istreambuf_iterator<char>(stream), {} };
  const std::vector<std::uint8_t> data(bytes.begin(), bytes.end());
  LLVMFuzzerTestOneInput(data.data(), data.size());
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i)
  {
    if (std::filesystem::is_directory(argv[i]))
    {
      const std::filesystem::directory_iterator folder(argv[i]);
      std::copy(begin(folder), end(folder), std::back_inserter(files));
    }
    else
    {
      files.emplace_back(argv[i]);
    }
  }
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files)
  {
    Replay(file);
  }
  std::cout << files.size() << " files\n";
  return check::Verdict("Replay");
}
