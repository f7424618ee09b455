// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_NoMoreThreads_h
#define Testing_Cxx_NoMoreThreads_h

#include <pthread.h>

#include <cstddef>

/** While it lives, no thread can be started: each would have a stack of more than all addresses. */
class NoMoreThreads
{
public:
  NoMoreThreads()
  {
    pthread_getattr_default_np(&this->Before);
    pthread_attr_t attributes = this->Before;
    pthread_attr_setstacksize(&attributes, std::size_t(1) << 60);
    pthread_setattr_default_np(&attributes);
  }
  ~NoMoreThreads() { pthread_setattr_default_np(&this->Before); }
  NoMoreThreads(const NoMoreThreads&) = delete;
  void operator=(const NoMoreThreads&) = delete;

private:
  pthread_attr_t Before{};
};

#endif
