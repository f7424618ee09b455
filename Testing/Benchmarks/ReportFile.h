// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_ReportFile_h
#define Testing_Benchmarks_ReportFile_h

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <unistd.h>

/** A file that is written at once when all that it holds is there: a run that fails, or is
 * interrupted, leaves the one of the run before as it is, another run's too, and nothing else. */
class ReportFile
{
public:
  /** Throws std::runtime_error where nothing can be written, as Keep() does. */
  explicit ReportFile(const std::string& path)
    : Path(path)
    , Part(path + "." + std::to_string(getpid()) + ".part")
  {
    if (std::filesystem::is_directory(path))
    {
      throw std::runtime_error("'" + path + "' is a folder; give the name of a file");
    }
    this->WritePart(); // Only to be told now, and not after half an hour.
    std::filesystem::remove(this->Part);
  }

  std::ostream& GetStream() { return this->Stream; }

  /** Puts what the stream holds in its place. */
  void Keep() const
  {
    this->WritePart();
    std::filesystem::rename(this->Part, this->Path);
  }

private:
  void WritePart() const
  {
    std::ofstream file(this->Part);
    file << this->Stream.str();
    file.close();
    if (!file)
    {
      std::error_code ignored;
      std::filesystem::remove(this->Part, ignored);
      throw std::runtime_error("cannot write to '" + this->Path + "'");
    }
  }

  std::string Path;
  std::string Part;
  std::ostringstream Stream;
};

#endif
