// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_MemoryLimit_h
#define Testing_Cxx_MemoryLimit_h

#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

constexpr std::size_t Megabyte = std::size_t(1) << 20;

/** While it lives, this process gets so many more bytes and no more. Not with a sanitizer, which
 * reserves more addresses than any limit. */
class MemoryLimit
{
public:
  explicit MemoryLimit(std::size_t bytes)
  {
    getrlimit(RLIMIT_AS, &this->Before);
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit = this->Before;
    limit.rlim_cur = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + bytes;
    setrlimit(RLIMIT_AS, &limit);
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &this->Before); }
  MemoryLimit(const MemoryLimit&) = delete;
  void operator=(const MemoryLimit&) = delete;

private:
  rlimit Before{};
};

#endif
