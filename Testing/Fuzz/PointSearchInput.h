// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Fuzz_PointSearchInput_h
#define Testing_Fuzz_PointSearchInput_h

#include "BorderNumbers.h"
#include "FuzzBytes.h"
#include "FuzzPoints.h"
#include "PointQuery.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

/**
 * Points and queries, made from bytes of any kind. They are a list of steps: the low half of a byte
 * says what is done, its high half is an argument of it, and what else is needed follows. Points
 * are made one by one, or many at a time, in units of a scale from an origin, both of which are set
 * by steps, too. What needs an earlier point names it by a byte.
 */
template <typename Real>
class PointSearchInput
{
public:
  static constexpr std::size_t MostPoints = 400; // More of either is slower, and finds no more.
  static constexpr std::size_t MostQueries = 24;

  explicit PointSearchInput(FuzzBytes& bytes)
    : Bytes(bytes)
  {
    while (!this->Bytes.IsEmpty())
    {
      this->ReadStep();
    }
  }

  hashedoctree::PointSpan<3, Real> GetPoints() const { return this->Points.GetSpan(); }
  const std::vector<PointQuery>& GetQueries() const { return this->Queries; }

private:
  using Position = hashedoctree::Position<3>;

  void ReadStep()
  {
    const unsigned byte = this->Bytes.ReadByte();
    const unsigned argument = byte / 16;
    switch (byte % 16)
    {
      case 0:
        this->Points.Add(this->ReadNearby(this->Origin));
        break;
      case 1:
        this->Points.Add(this->template ReadRaw<Real>());
        break;
      case 2:
        this->AddCopies(this->ReadPoint(), argument + 1);
        break;
      case 3:
        this->AddLattice(2 + argument % 4);
        break;
      case 4:
        this->Points.AddCloud(
          this->Origin, this->Scale, 8 * (argument + 1), this->Bytes.ReadByte());
        break;
      case 5:
        this->Points.Add(this->template ReadBeside<Real>(argument));
        break;
      case 6:
        this->Scale = GetScale(argument);
        break;
      case 7:
        this->SetOrigin(argument);
        break;
      case 8:
        this->Points.Add(this->ReadSpecial(argument));
        break;
      case 15:
        this->ReadBox(argument);
        break;
      default:
        this->ReadQuery(static_cast<PointQuery::Kinds>(byte % 4), argument);
        break;
    }
  }

  void AddCopies(const Position& x, unsigned count)
  {
    for (unsigned i = 0; i < count; ++i)
    {
      this->Points.Add(x);
    }
  }

  void AddLattice(unsigned side)
  {
    const Position corner = this->ReadNearby(this->Origin);
    for (unsigned i = 0; i < side * side * side; ++i)
    {
      const unsigned steps[] = { i % side, i / side % side, i / (side * side) };
      Position x = corner;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        x[axis] += this->Scale * steps[axis];
      }
      this->Points.Add(x);
    }
  }

  void SetOrigin(unsigned argument)
  {
    if (argument % 2 == 0)
    {
      this->Origin.fill(GetOffset(argument / 2));
    }
    else
    {
      this->Origin = this->ReadPoint();
    }
  }

  void ReadQuery(PointQuery::Kinds kind, unsigned argument)
  {
    PointQuery query{};
    query.Kind = kind;
    query.X = this->ReadPosition(argument);
    const unsigned byte = this->Bytes.ReadByte();
    if (kind == PointQuery::ClosestFew)
    {
      query.Count = byte < 250 ? byte : std::size_t(1000) << byte % 50;
    }
    else if (kind != PointQuery::Closest)
    {
      this->ReadRadius(query, byte);
    }
    this->AddQuery(query);
  }

  void ReadBox(unsigned argument)
  {
    PointQuery query{};
    query.Kind = PointQuery::InBox;
    query.X = this->ReadPosition(argument);
    const unsigned byte = this->Bytes.ReadByte();
    query.Upper = this->ReadPosition(byte);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (query.X[axis] > query.Upper[axis] && byte < 240) // Else it is no box.
      {
        std::swap(query.X[axis], query.Upper[axis]);
      }
    }
    this->AddQuery(query);
  }

  void AddQuery(const PointQuery& query)
  {
    if (this->Queries.size() < MostQueries)
    {
      this->Queries.push_back(query);
    }
  }

  Position ReadPosition(unsigned argument)
  {
    switch (argument % 8)
    {
      case 0:
        return this->ReadPoint();
      case 1:
        return this->template ReadBeside<Real>(this->Bytes.ReadByte());
      case 2:
        return this->ReadNearby(this->Origin);
      case 3:
        return this->template ReadBeside<double>(this->Bytes.ReadByte());
      case 4:
        return this->ReadNearby(this->ReadPoint());
      case 5:
        return this->ReadMidpoint();
      case 6:
        return this->ReadSpecial(this->Bytes.ReadByte());
      default:
        return this->template ReadRaw<double>();
    }
  }

  void ReadRadius(PointQuery& query, unsigned byte)
  {
    query.Neighbor = byte / 8;
    switch (byte % 8)
    {
      case 0:
      case 1:
        query.RadiusKind = PointQuery::OfNeighbor;
        break;
      case 2:
        query.RadiusKind = PointQuery::BelowNeighbor;
        break;
      case 3:
        query.RadiusKind = PointQuery::AboveNeighbor;
        break;
      case 4:
        query.RadiusKind = PointQuery::OfNeighbor;
        query.Neighbor = this->Bytes.template Read<std::uint16_t>();
        break;
      case 5:
        query.Radius = this->Scale * this->Bytes.ReadByte();
        break;
      case 6:
        query.Radius = GetSpecial(byte / 8);
        break;
      default:
        query.Radius = this->Bytes.template Read<double>();
        break;
    }
  }

  /** An earlier point; the origin where there is none. */
  Position ReadPoint() { return this->Points.Get(this->Bytes.ReadByte(), this->Origin); }

  Position ReadNearby(Position x)
  {
    for (double& coordinate : x)
    {
      coordinate += this->Scale * this->Bytes.template Read<std::int8_t>();
    }
    return x;
  }

  Position ReadMidpoint()
  {
    Position x = this->ReadPoint();
    const Position other = this->ReadPoint();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      x[axis] = 0.5 * x[axis] + 0.5 * other[axis];
    }
    return x;
  }

  /** An earlier point with one coordinate that is a border case. */
  Position ReadSpecial(unsigned argument)
  {
    Position x = this->ReadPoint();
    x[argument % 3] = GetSpecial(this->Bytes.ReadByte());
    return x;
  }

  template <typename Coordinate>
  Position ReadRaw()
  {
    Position x{};
    for (double& coordinate : x)
    {
      coordinate = static_cast<double>(this->Bytes.template Read<Coordinate>());
    }
    return x;
  }

  /** The next position from an earlier point along an axis. */
  template <typename Coordinate>
  Position ReadBeside(unsigned argument)
  {
    constexpr Coordinate infinity = std::numeric_limits<Coordinate>::infinity();
    Position x = this->ReadPoint();
    double& coordinate = x[argument / 2 % 3];
    coordinate = static_cast<double>(
      std::nextafter(ToReal<Coordinate>(coordinate), argument % 2 == 0 ? infinity : -infinity));
    return x;
  }

  FuzzBytes& Bytes;
  double Scale = 1.0;
  Position Origin{};
  FuzzPoints<3, Real> Points{ MostPoints };
  std::vector<PointQuery> Queries;
};

#endif
