// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorOptions.h"

#include "LocatorPeers.h"
#include "LocatorSamples.h"
#include "NumberOption.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

namespace locator_benchmark
{
namespace
{
std::vector<std::string> Split(const std::string& list)
{
  std::vector<std::string> words;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');)
  {
    words.push_back(word);
  }
  return words;
}

std::string Join(const std::vector<std::string>& words)
{
  std::string joined;
  for (const std::string& word : words)
  {
    joined.append(joined.empty() ? "" : ",").append(word);
  }
  return joined;
}

std::vector<std::string> GetPeerNames()
{
  std::vector<std::string> names;
  for (const PeerKind& kind : GetPeerKinds())
  {
    names.push_back(kind.Name);
  }
  return names;
}

/** The names in the list, each once and in the order in which they are known. */
std::vector<std::string> ReadNames(
  const std::string& option, const std::string& list, const std::vector<std::string>& known)
{
  const std::vector<std::string> words = Split(list);
  for (const std::string& word : words)
  {
    if (std::find(known.begin(), known.end(), word) == known.end())
    {
      throw std::runtime_error(
        std::string(option).append(" does not know '").append(word).append("'; it knows ") +
        Join(known));
    }
  }
  std::vector<std::string> names;
  std::copy_if(known.begin(), known.end(), std::back_inserter(names),
    [&words](const auto& name)
    { return std::find(words.begin(), words.end(), name) != words.end(); });
  if (names.empty())
  {
    throw std::runtime_error(option + " needs a list of " + Join(known));
  }
  return names;
}

/** The whole numbers in the list, each once, from small to large. */
template <typename Integer>
std::vector<Integer> ReadCounts(
  const std::string& option, const std::string& list, Integer smallest, Integer largest)
{
  std::vector<Integer> counts;
  for (const std::string& word : Split(list))
  {
    counts.push_back(ReadNumberOption(option, word, smallest, largest));
  }
  std::sort(counts.begin(), counts.end());
  counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
  if (counts.empty())
  {
    throw std::runtime_error(option + " needs a list of numbers");
  }
  return counts;
}

std::vector<Operation> ReadOperations(const std::string& option, const std::string& list)
{
  const std::vector<std::string>& known = GetOperationNames();
  std::vector<Operation> operations;
  for (const std::string& name : ReadNames(option, list, known))
  {
    const auto place = std::find(known.begin(), known.end(), name);
    operations.push_back(static_cast<Operation>(place - known.begin()));
  }
  return operations;
}

/** Google Benchmark's own, but for those under which it measures nothing, or keeps it from us. */
void CheckOther(const std::string& name)
{
  for (const std::string refused : { "--benchmark_list_tests", "--benchmark_report_aggregates_only",
         "--benchmark_display_aggregates_only", "--benchmark_out" })
  {
    if (name == refused)
    {
      throw std::runtime_error(
        name + " cannot be used: times go to locator.md and locator.json, all of them");
    }
  }
}

/** The terrain may come last; that its file is missing should be said at once. */
void CheckTerrain(const LocatorOptions& options)
{
  const bool isWanted = !options.PointsPath &&
    std::find(options.Data.begin(), options.Data.end(), "terrain") != options.Data.end();
  if (isWanted && !options.HelpWanted && !std::ifstream(options.TerrainPath))
  {
    throw std::runtime_error("no terrain file '" + options.TerrainPath +
      "'; make it with pvpython Data/make_terrain.py FILE, and give --terrain FILE");
  }
}

using Setter = std::function<void(LocatorOptions&, const std::string&)>;

/** What each option of ours does with its value. */
std::map<std::string, Setter> MakeSetters()
{
  std::map<std::string, Setter> setters;
  setters["--data"] = [](LocatorOptions& options, const std::string& value)
  { options.Data = ReadNames("--data", value, GetSampleNames()); };
  // More points than floats can tell apart would help nobody.
  setters["--sizes"] = [](LocatorOptions& options, const std::string& value)
  {
    options.Sizes = ReadCounts<std::size_t>("--sizes", value, LocatorOptions::LeastSize, 100000000);
  };
  setters["--points"] = [](LocatorOptions& options, const std::string& value)
  { options.PointsPath = value; };
  setters["--queries"] = [](LocatorOptions& options, const std::string& value)
  { options.Queries = ReadNames("--queries", value, GetQueryNames()); };
  setters["--operations"] = [](LocatorOptions& options, const std::string& value)
  { options.Operations = ReadOperations("--operations", value); };
  setters["--threads"] = [](LocatorOptions& options, const std::string& value)
  { options.Threads = ReadCounts<int>("--threads", value, 1, 1024); };
  setters["--peers"] = [](LocatorOptions& options, const std::string& value)
  { options.Peers = ReadNames("--peers", GetPeerKinds()[0].Name + "," + value, GetPeerNames()); };
  setters["--repetition-time"] = [](LocatorOptions& options, const std::string& value)
  { options.RepetitionTime = ReadNumberOption("--repetition-time", value, 0.0001, 60.0); };
  setters["--terrain"] = [](LocatorOptions& options, const std::string& value)
  { options.TerrainPath = value; };
  setters["--output"] = [](LocatorOptions& options, const std::string& value)
  { options.OutputDirectory = value; };
  return setters;
}
}

LocatorOptions ReadOptions(const std::vector<std::string>& arguments)
{
  LocatorOptions options;
  std::map<std::string, Setter> setters = MakeSetters();
  setters["--peers"](options, Join(GetPeerNames()));
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    const std::size_t equals = arguments[i].find('=');
    const std::string name = arguments[i].substr(0, equals);
    const auto setter = setters.find(name);
    options.HelpWanted = options.HelpWanted || name == "--help";
    if (setter == setters.end())
    {
      CheckOther(name);
      options.Others.push_back(arguments[i]);
    }
    else if (equals != std::string::npos)
    {
      setter->second(options, arguments[i].substr(equals + 1));
    }
    else if (++i < arguments.size())
    {
      setter->second(options, arguments[i]);
    }
    else
    {
      throw std::runtime_error(name + " needs a value");
    }
  }
  CheckTerrain(options);
  return options;
}

std::vector<LocatorCase> LocatorOptions::MakeCases(const std::string& data, std::size_t size) const
{
  std::vector<LocatorCase> cases;
  for (const Operation operation : this->Operations)
  {
    const bool isBuild = operation == Operation::Build;
    for (const std::string& queries : isBuild ? std::vector<std::string>{ "-" } : this->Queries)
    {
      for (const int threads : this->Threads)
      {
        for (const std::string& peer : this->Peers)
        {
          cases.push_back({ data, size, queries, operation, threads, peer });
        }
      }
    }
  }
  return cases;
}

std::string GetHelp()
{
  return "Compares point locators in turns, and writes locator.md and locator.json.\n"
         "  --data LIST             of " +
    Join(GetSampleNames()) +
    "; default: all but tails and plane\n"
    "  --sizes LIST            numbers of points; default 10000,100000,1000000\n"
    "  --points FILE           in place of these two: points of your own, in float, from a .vtp "
    "file\n"
    "  --queries LIST          of " +
    Join(GetQueryNames()) +
    "; default: near and uniform\n"
    "  --operations LIST       of " +
    Join(GetOperationNames()) +
    "; default: all but closest100\n"
    "  --peers LIST            of " +
    Join(GetPeerNames()) + "; " + GetPeerKinds()[0].Name +
    " always takes part\n"
    "  --threads LIST          default 1,2\n"
    "  --repetition-time S     seconds after which a repetition stops counting; default 0.04\n"
    "  --terrain FILE          that Data/make_terrain.py wrote; for the data set terrain\n"
    "  --output DIRECTORY      default: the current one\n"
    "A list has commas and no blanks; of peers it is all of them by default. Google Benchmark's "
    "options work, too, but for --benchmark_list_tests, --benchmark_out and "
    "--benchmark_..._aggregates_only:\n";
}
}
