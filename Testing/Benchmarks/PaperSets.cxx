// SPDX-License-Identifier: BSD-3-Clause
#include "PaperSets.h"

#include <fstream>
#include <stdexcept>

namespace paper_benchmark
{
const std::vector<PaperSet>& GetPaperSets()
{
  static const std::vector<PaperSet> sets{ { "sphere_1k", "Sphere", 4.4, 6, 4 },
    { "scan_35k", "Bunny", 144, 9, 7 }, { "stadium_10k", "Maracanã", 190, 21, 21 },
    { "scan_100k", "David head", 395, 13, 9 }, { "gyroid_100k", "Pig", 401, 11, 10 },
    { "csg_82k", "CSG", 529, 19, 8 }, { "volcano_133k", "Volcano", 551, 21, 9 },
    { "flow_257k", "Fighter", 723, 14, 9 }, { "flow_208k", "Deltao", 1210, 20, 12 },
    { "scan_350k", "David", 1534, 21, 10 }, { "random_sphere_500k", "Rnd Sphere", 2883, 18, 9 },
    { "scan_438k", "Dragon", 3060, 21, 10 }, { "scan_544k", "Happy", 3617, 21, 10 },
    { "gyroid_883k", "Blade", 5412, 16, 10 }, { "scan_1669k", "Chair", 9255, 18, 11 },
    { "random_cube_4000k", "Rnd Cube", 15675, 12, 8 },
    { "scan_5000k", "Thai Statue", 22296, 20, 12 } };
  return sets;
}

std::vector<float> ReadPoints(const std::string& folder, const PaperSet& set)
{
  const std::string path = folder + "/" + set.Name + ".xyz";
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file)
  {
    return {};
  }
  const auto bytes = static_cast<std::size_t>(file.tellg());
  std::vector<float> points(bytes / sizeof(float));
  file.seekg(0);
  if (points.empty() || bytes % (3 * sizeof(float)) != 0 ||
    !file.read(reinterpret_cast<char*>(points.data()), static_cast<std::streamsize>(bytes)))
  {
    throw std::runtime_error("'" + path + "' holds no points of three floats");
  }
  return points;
}
}
