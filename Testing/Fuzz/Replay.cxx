// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <vector>

/** What a fuzzer defines. */
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{
using Paths = std::vector<std::filesystem::path>;

/** The given files, and those in the given folders, in an order that does not change. */
Paths FindFiles(const Paths& given)
{
  Paths files;
  for (const auto& path : given)
  {
    if (std::filesystem::is_directory(path))
    {
      for (const auto& entry : std::filesystem::directory_iterator(path))
      {
        files.push_back(entry.path());
      }
    }
    else
    {
      files.push_back(path);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

void Replay(const std::filesystem::path& path)
{
  std::cerr << path.filename().string() << std::endl; // An input that fails ends the process.
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw std::runtime_error("cannot read " + path.string());
  }
  const std::vector<char> content{ std::istreambuf_iterator<char>(file), {} };
  const std::vector<std::uint8_t> bytes(content.begin(), content.end());
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}
}

/** Runs a fuzzer's body on each file of its corpus, which any compiler can. */
int main(int argc, char* argv[])
{
  try
  {
    const Paths files = FindFiles(Paths(argv + 1, argv + argc));
    std::for_each(files.begin(), files.end(), Replay);
    if (files.empty())
    {
      std::cerr << "error: no files to replay; give files of a corpus, or its folder" << std::endl;
      return 1;
    }
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << "error: " << error.what() << std::endl;
    return 1;
  }
}
