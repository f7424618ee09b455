// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_NoMoreThreads_h
#define Testing_Cxx_NoMoreThreads_h

#include <gtest/gtest.h>

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
    EXPECT_EQ(pthread_setattr_default_np(&attributes), 0);
  }
  ~NoMoreThreads()
  {
    pthread_setattr_default_np(&this->Before);
    pthread_attr_destroy(&this->Before);
  }
  NoMoreThreads(const NoMoreThreads&) = delete;
  void operator=(const NoMoreThreads&) = delete;

private:
  pthread_attr_t Before{};
};

#endif
