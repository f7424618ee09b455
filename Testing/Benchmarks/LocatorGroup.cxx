// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorGroup.h"

namespace locator_benchmark
{
LocatorGroup::LocatorGroup(const LocatorOptions& options, const LocatorData& data)
  : Options(options)
  , Data(data)
{
  // A repetition does not get through them but by the shortest searches (below 100 ns), so that the
  // caches do not know the way.
  constexpr std::size_t numberOfQueries = 400000;
  this->BuildPeers();
  // Of all, nanoflann slows down least on odd data.
  const std::unique_ptr<LocatorPeer> helper = MakeNanoflannPeer();
  helper->Build(this->Data);
  this->Queries = MakeQueries(this->Data, *helper, numberOfQueries);
}

LocatorGroup::~LocatorGroup()
{
  benchmark::ClearRegisteredBenchmarks();
}

void LocatorGroup::BuildPeers()
{
  UseThreads(1);
  for (const std::string& name : this->Options.Peers)
  {
    this->Peers[name] = GetPeerKind(name).Make();
    this->Peers[name]->Build(this->Data);
    // VTK's k-d tree makes one of its lists in the first radius search, which two threads must not.
    Answer answer;
    this->Peers[name]->FindWithin(0.0, Position{}, answer);
  }
}

void LocatorGroup::Register()
{
  for (const LocatorCase& which :
    this->Options.MakeCases(this->Data.GetName(), this->Data.GetNumberOfPoints()))
  {
    // One iteration: it lasts as long as a repetition is to last.
    benchmark::RegisterBenchmark(
      which.GetName().c_str(), [this, which](benchmark::State& state) { this->Run(state, which); })
      ->Iterations(1)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
  }
}

void LocatorGroup::Run(benchmark::State& state, const LocatorCase& which)
{
  UseThreads(which.Threads);
  LocatorPeer& peer = *this->Peers[which.Peer];
  const bool isBuild = which.What == Operation::Build;
  const std::string error = isBuild ? std::string() : this->FindError(which);
  if (!error.empty())
  {
    state.SkipWithError(error.c_str());
    return;
  }
  Timing timing;
  for (auto _ : state)
  {
    timing = isBuild ? TimeBuilds(GetPeerKind(which.Peer), this->Data, this->Options.RepetitionTime)
                     : TimeQueries(peer, this->MakeQuestion(which), this->Options.RepetitionTime);
    state.SetIterationTime(timing.Seconds);
  }
  using benchmark::Counter;
  state.counters["seconds_each"] =
    Counter(static_cast<double>(timing.Count), Counter::Flags(Counter::kIsRate | Counter::kInvert));
  state.counters["index_bytes_per_point"] =
    static_cast<double>(peer.GetIndexBytes()) / static_cast<double>(this->Data.GetNumberOfPoints());
  if (isBuild && which.Threads > 1)
  {
    state.counters["gain_of_threads"] = MeasureGainOfThreads(which.Threads);
  }
  if (!isBuild)
  {
    state.counters["mean_hits"] = this->GetCheck(which).GetMeanHits();
    const CheckResult& result = this->CheckResults[which.GetName()];
    state.counters["checked_answers"] = static_cast<double>(result.Checked);
    state.counters["different_answers"] = static_cast<double>(result.Different);
  }
}

std::string LocatorGroup::FindError(const LocatorCase& which)
{
  LocatorCheck& check = this->GetCheck(which);
  const std::string name = which.GetName();
  if (this->CheckResults.count(name) == 0)
  {
    this->CheckResults[name] = check.Check(*this->Peers[which.Peer]);
  }
  if (!check.IsSound())
  {
    return "our distances are not those of a comparison with every point";
  }
  const std::size_t differences = this->CheckResults[name].Different;
  return differences > 0 && GetPeerKind(which.Peer).Exact
    ? "other distances than ours at " + std::to_string(differences) + " positions"
    : std::string();
}

LocatorCheck& LocatorGroup::GetCheck(const LocatorCase& which)
{
  // Right answers depend neither on the peer nor on the threads.
  LocatorCase key = which.WithPeer("");
  key.Threads = 0;
  std::unique_ptr<LocatorCheck>& check = this->Checks[key.GetName()];
  if (!check)
  {
    check = std::make_unique<LocatorCheck>(
      this->Data, this->MakeQuestion(which), *this->Peers[this->Options.Peers[0]]);
  }
  return *check;
}

Question LocatorGroup::MakeQuestion(const LocatorCase& which) const
{
  return { which.What, this->Queries.Radius, &this->Queries.Get(which.Queries) };
}
}
