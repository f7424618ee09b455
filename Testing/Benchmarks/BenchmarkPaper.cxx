// SPDX-License-Identifier: BSD-3-Clause
/**
 * The experiments of the paper (section 5, Tables 1 to 3, claims): trees with pointers, the paper's
 * own layout and ours, over the same points, in turns. Every structure's answers are checked.
 */
#include "NumberOption.h"
#include "PaperMeasurement.h"
#include "PaperReport.h"
#include "ReportFile.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <stdexcept>

using namespace paper_benchmark;

namespace
{
/** Of two repetitions no median could tell much. */
constexpr int FewestRepetitions = 3;
constexpr int MostRepetitions = 1000;
/** Point sets above this are left out of a quick run, and of Data/make_point_sets.py --quick. */
constexpr std::size_t QuickLimit = 150000;

struct Options
{
  std::string Points = ".";
  std::string Output = "paper.md";
  std::string Sets; ///< Names between commas; all when empty.
  int Repetitions = 5;
  bool Quick = false;
  bool HelpWanted = false;
};

Options ReadOptions(const std::vector<std::string>& arguments)
{
  Options options;
  const auto getValue = [&arguments](std::size_t i)
  {
    if (i >= arguments.size())
    {
      throw std::runtime_error(arguments.back() + " needs a value");
    }
    return arguments[i];
  };
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    if (arguments[i] == "--quick")
    {
      options.Quick = true;
    }
    else if (arguments[i] == "--help")
    {
      options.HelpWanted = true;
    }
    else if (arguments[i] == "--points")
    {
      options.Points = getValue(++i);
    }
    else if (arguments[i] == "--output")
    {
      options.Output = getValue(++i);
    }
    else if (arguments[i] == "--sets")
    {
      options.Sets = getValue(++i);
    }
    else if (arguments[i] == "--repetitions")
    {
      options.Repetitions =
        ReadNumberOption("--repetitions", getValue(++i), FewestRepetitions, MostRepetitions);
    }
    else
    {
      throw std::runtime_error("unknown argument '" + arguments[i] + "'; try --help");
    }
  }
  return options;
}

constexpr const char* Help = "Repeats the paper's experiments, and writes them as Markdown.\n"
                             "  --points FOLDER   that Data/make_point_sets.py wrote\n"
                             "  --output FILE     default: paper.md\n"
                             "  --sets A,B        only these; default: all\n"
                             "  --repetitions N   default 5\n"
                             "  --quick           only the sets of up to 150,000 points\n";

std::vector<PaperSet> ChooseSets(const Options& options)
{
  std::vector<PaperSet> sets = GetPaperSets();
  if (!options.Sets.empty())
  {
    sets.clear();
    std::istringstream names(options.Sets);
    for (std::string name; std::getline(names, name, ',');)
    {
      const auto set = std::find_if(GetPaperSets().begin(), GetPaperSets().end(),
        [&name](const PaperSet& other) { return other.Name == name; });
      if (set == GetPaperSets().end())
      {
        throw std::runtime_error(
          "no set '" + name + "'; the names are those of Data/make_point_sets.py");
      }
      sets.push_back(*set);
    }
  }
  if (options.Quick)
  {
    sets.erase(std::remove_if(sets.begin(), sets.end(),
                 [](const PaperSet& set) { return set.Points > QuickLimit; }),
      sets.end());
  }
  if (sets.empty())
  {
    throw std::runtime_error("no set is left; try other --sets, or without --quick");
  }
  return sets;
}

std::vector<PaperResults> MeasureSets(const Options& options)
{
  const std::vector<PaperSet> sets = ChooseSets(options);
  for (const PaperSet& set : sets)
  {
    ReadPoints(options.Points, set); // What is missing is told at once, not after half an hour.
  }
  std::vector<PaperResults> results;
  for (const PaperSet& set : sets)
  {
    const std::vector<float> points = ReadPoints(options.Points, set);
    const double seconds =
      GetSeconds([&] { results.push_back(MeasureSet(set, points, options.Repetitions)); });
    std::printf("%s: %zu points, %zu nodes, %.0f s\n", set.Name.c_str(), results.back().Points,
      results.back().Nodes, seconds);
    std::fflush(stdout);
  }
  return results;
}

int Run(const Options& options)
{
  if (options.HelpWanted)
  {
    std::cout << Help;
    return 0;
  }
  ReportFile markdown(options.Output);
  const std::vector<PaperResults> results = MeasureSets(options);
  WriteReport(results, options.Repetitions, markdown.GetStream());
  markdown.Keep();
  std::size_t different = 0;
  for (const PaperResults& set : results)
  {
    different += set.DifferentAnswers;
  }
  if (different != 0)
  {
    std::cerr << "error: " << different << " answers differ\n";
  }
  return different == 0 ? 0 : 1;
}
}

int main(int argc, char** argv)
{
  try
  {
    return Run(ReadOptions({ argv + 1, argv + argc }));
  }
  catch (const std::exception& error)
  {
    std::cerr << "error: " << error.what() << "\n";
    return 2;
  }
}
