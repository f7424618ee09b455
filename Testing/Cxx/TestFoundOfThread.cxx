// SPDX-License-Identifier: BSD-3-Clause
#include "FoundOfThread.h"

#include "vtkNew.h"

#include <gtest/gtest.h>

#include <thread>

using namespace hashedoctree;

TEST(TestFoundOfThread, IsEmptyAndKeepsItsMemory)
{
  constexpr std::size_t few = 1000;
  {
    FoundOfThread<int> found;
    found.Get().assign(few, 7);
  }
  FoundOfThread<int> found;
  EXPECT_TRUE(found.Get().empty());
  EXPECT_GE(found.Get().capacity(), few);
}

TEST(TestFoundOfThread, GivesBackMuchMemory)
{
  {
    FoundOfThread<int> found;
    found.Get().assign(10000000, 7);
  }
  EXPECT_LT(FoundOfThread<int>().Get().capacity(), 100000U);
}

TEST(TestFoundOfThread, IsThereWhenTheMemoryOfTheThreadHasEnded)
{
  struct Late
  {
    std::size_t* Found;
    ~Late()
    {
      FoundOfThread<int> found;
      found.Get().resize(100000, 7); // Frees what it has, and must not have any more.
      *this->Found = found.Get().size();
    }
  };
  std::size_t size = 0;
  std::thread(
    [&size]
    {
      thread_local Late late{ &size }; // Ends after what is made after it.
      FoundOfThread<int> found;
      found.Get().resize(1000, *late.Found == 0 ? 7 : 8);
    })
    .join();
  EXPECT_EQ(size, 100000U);
}

TEST(TestFoundOfThread, ReplacesTheIdsOfAList)
{
  vtkNew<vtkIdList> list;
  list->InsertNextId(5);
  list->InsertNextId(6);
  const auto twice = [](int value) { return 2 * value; };
  FoundOfThread<int> found;
  found.Get() = { 1, 2, 3 };
  found.CopyTo(list, twice);
  ASSERT_EQ(list->GetNumberOfIds(), 3);
  EXPECT_EQ(list->GetId(0), 2);
  EXPECT_EQ(list->GetId(2), 6);
  found.Get().clear();
  found.CopyTo(list, twice);
  EXPECT_EQ(list->GetNumberOfIds(), 0);
}
