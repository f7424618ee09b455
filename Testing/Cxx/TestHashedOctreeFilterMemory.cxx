// SPDX-License-Identifier: BSD-3-Clause

// What the filter does when there is no memory for the tree. (For the arrays of the outputs it
// cannot be tested: where VTK is compiled with assertions, as in Debian's ParaView, they end the
// program themselves.)
#include "MemoryLimit.h"
#include "PointSamples.h"
#include "Sanitized.h"
#include "TestedFilter.h"

#include "vtkSMPTools.h"

TEST(TestHashedOctreeFilterMemory, WithoutRoomForTheTreeThereIsOneErrorAndNothingElse)
{
  if (Sanitized)
  {
    GTEST_SKIP() << "sanitizers reserve more memory than the limit";
  }
  vtkSMPTools::SetBackend("Sequential"); // To start a thread takes more than what is left.
  TestedFilter filter(MakeUniformPoints<3, double>(100000, 271));
  {
    const MemoryLimit limit(Megabyte / 2);
    filter->Update();
  }
  ASSERT_EQ(filter.Errors.size(), 1U);
  EXPECT_NE(filter.Errors[0].find("not enough memory for the octree"), std::string::npos)
    << filter.Errors[0];
  filter.Errors.clear();
  filter.PipelineErrors.clear();
  filter.ExpectEmptyOutputs();

  filter->Modified();
  filter.Update();
  EXPECT_GT(filter.GetCells()->GetNumberOfCells(), 50000);
}
