// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_ReportFile_h
#define Testing_Benchmarks_ReportFile_h

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <unistd.h>

/** A file that is written beside its place and put there when it is whole: a run that fails, or is
 * interrupted, leaves the one of the run before as it is, and of another run at the same time. */
class ReportFile
{
public:
  /** Throws std::runtime_error where nothing can be written, as all members do. */
  explicit ReportFile(const std::string& path)
    : Path(RequireNoFolder(path))
    , Stream(this->GetPart())
  {
    this->RequireWritten();
  }
  ~ReportFile()
  {
    std::error_code ignored;
    std::filesystem::remove(this->GetPart(), ignored);
  }
  ReportFile(const ReportFile&) = delete;
  ReportFile& operator=(const ReportFile&) = delete;

  std::ostream& GetStream() { return this->Stream; }

  /** Puts what was written in its place. */
  void Keep()
  {
    this->Stream.close();
    this->RequireWritten();
    std::filesystem::rename(this->GetPart(), this->Path);
  }

private:
  static const std::string& RequireNoFolder(const std::string& path)
  {
    if (std::filesystem::is_directory(path))
    {
      throw std::runtime_error("'" + path + "' is a folder; give the name of a file");
    }
    return path;
  }
  std::string GetPart() const { return this->Path + "." + std::to_string(getpid()) + ".part"; }
  void RequireWritten() const
  {
    if (!this->Stream)
    {
      throw std::runtime_error("cannot write to '" + this->Path + "'");
    }
  }

  std::string Path;
  std::ofstream Stream;
};

#endif
