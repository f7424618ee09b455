// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Fuzz_LeafSearchInput_h
#define Testing_Fuzz_LeafSearchInput_h

#include "BorderNumbers.h"
#include "FuzzBytes.h"
#include "FuzzPoints.h"
#include "LeafQuery.h"

#include <cmath>
#include <vector>

/**
 * Points in the unit cube, in which the tree's cells have simple coordinates, and queries, made
 * from bytes of any kind. They are a list of steps as in PointSearchInput.h.
 */
template <int Dim>
class LeafSearchInput
{
public:
  static constexpr std::size_t MostPoints = 64; // More of either is slower, and finds no more.
  static constexpr std::size_t MostQueries = 8;

  explicit LeafSearchInput(FuzzBytes& bytes)
    : Bytes(bytes)
  {
    while (!this->Bytes.IsEmpty())
    {
      this->ReadStep();
    }
  }

  hashedoctree::PointSpan<Dim, double> GetPoints() const { return this->Points.GetSpan(); }
  const std::vector<LeafQuery<Dim>>& GetQueries() const { return this->Queries; }

private:
  using Key = hashedoctree::MortonKey<Dim>;
  using Position = hashedoctree::Position<Dim>;

  void ReadStep()
  {
    const unsigned byte = this->Bytes.ReadByte();
    const unsigned argument = byte / 8;
    switch (byte % 8)
    {
      case 0:
        this->Points.Add(this->template ReadRaw<std::uint8_t>());
        break;
      case 1:
        this->Points.Add(this->template ReadRaw<std::uint32_t>());
        break;
      case 2:
      case 3:
        this->Points.Add(this->ReadBeside(argument));
        break;
      case 4:
        this->AddCloud(argument + 1);
        break;
      default:
        this->ReadQuery(argument);
        break;
    }
  }

  /** Around an earlier point. */
  void AddCloud(unsigned count)
  {
    Position lower = this->ReadPoint();
    const double size = this->ReadSize();
    for (double& coordinate : lower)
    {
      coordinate -= size / 2;
    }
    this->Points.AddCloud(lower, size, count, this->Bytes.ReadByte());
  }

  void ReadQuery(unsigned argument)
  {
    LeafQuery<Dim> query{};
    query.X = argument % 2 == 0 ? this->ReadPoint() : this->template ReadRaw<std::uint8_t>();
    query.Depth = this->ReadDepth();
    query.StartDepth = this->ReadDepth();
    query.Radius = this->ReadRadius(argument / 2, std::ldexp(1.0, -query.Depth));
    if (this->Queries.size() < MostQueries)
    {
      this->Queries.push_back(query);
    }
  }

  double ReadRadius(unsigned argument, double side)
  {
    const unsigned byte = this->Bytes.ReadByte();
    switch (argument % 4)
    {
      case 0:
      case 1:
        return this->ReadDistance(byte) * side / 2;
      case 2:
        return byte * side / 16;
      default:
        return byte % 2 == 0 ? GetSpecial(byte / 2) : this->Bytes.template Read<double>();
    }
  }

  /** From the center of a cell to the corner of another, in half sides: cells at that distance
   * meet the ball, and those just beyond it do not. */
  double ReadDistance(unsigned byte)
  {
    double distance2 = byte * byte;
    for (int axis = 1; axis < Dim; ++axis)
    {
      const unsigned halves = this->Bytes.ReadByte() % 16;
      distance2 += halves * halves;
    }
    return std::sqrt(distance2);
  }

  /** An earlier point; the lower corner of the root where there is none. */
  Position ReadPoint() { return this->Points.Get(this->Bytes.ReadByte(), {}); }

  /** An earlier point, moved along an axis; left out of the tree where it leaves the root. */
  Position ReadBeside(unsigned argument)
  {
    Position x = this->ReadPoint();
    const double size = this->ReadSize();
    x[argument / 2 % Dim] += argument % 2 == 0 ? size : -size;
    return x;
  }

  /** In units of the range of a whole number, from 0 to 1. */
  template <typename Whole>
  Position ReadRaw()
  {
    Position x;
    for (double& coordinate : x)
    {
      const auto whole = static_cast<double>(this->Bytes.template Read<Whole>());
      coordinate = std::ldexp(whole, -8 * static_cast<int>(sizeof(Whole)));
    }
    return x;
  }

  int ReadDepth() { return static_cast<int>(this->Bytes.ReadByte() % (Key::MaxDepth + 1)); }
  /** The side of a node. */
  double ReadSize() { return std::ldexp(1.0, -this->ReadDepth()); }

  FuzzBytes& Bytes;
  FuzzPoints<Dim, double> Points{ MostPoints };
  std::vector<LeafQuery<Dim>> Queries;
};

#endif
