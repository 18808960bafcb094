// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Packing/HardSpheres.h"

#include "ruc/Base/Random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ruc
{
namespace
{
constexpr double Never = std::numeric_limits<double>::infinity();
constexpr int LeavesPlace = -1, HitsWall = -2;
// Collisions for each sphere in the pack, of which a sphere takes part in twice as many: between
// two rounds of exchanges, and between two looks at pressure and temperature
constexpr int CollisionsOfExchange = 1, CollisionsOfRound = 25;
// Events for each sphere after which the caller is asked also between two rounds: in thin packs
// spheres fly far between collisions
constexpr int EventsOfQuestion = 200;

// The first t >= 0 at which a t^2 + 2 b t + c falls to 0, which is what the squares of two spheres'
// distance and contact differ by. It is 0 where they touch and approach each other.
double FirstRoot(double a, double b, double c)
{
  if (c <= 0.0)
  {
    return b < 0.0 ? 0.0 : Never;
  }
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0 || (b >= 0.0 && a >= 0.0))
  {
    return Never;
  }
  const double root = c / (-b + std::sqrt(discriminant));
  return root >= 0.0 ? root : Never;
}
}

HardSpheres::HardSpheres(
  const SpherePack& pack, const Window& box, double largestGrowth, const Settings& settings)
  : Box(box)
  , Chosen(settings)
  , Unit(2.0 * std::accumulate(pack.Radius.begin(), pack.Radius.end(), 0.0) / pack.Size())
  , Degrees(3.0 * static_cast<double>(pack.Size()))
  , Rooms(pack, box, largestGrowth)
  , Room(pack.Size())
  , Reach(pack.Size())
  , Listed(pack.Size())
  , Near(pack.Size())
  , Grid(box, pack.Size(), this->Rooms.Least,
      this->Rooms.Greatest + this->Rooms.Of(this->Rooms.Greatest))
  , Partner(pack.Size(), LeavesPlace)
  , Count(pack.Size(), 0)
  , Stamp(pack.Size(), 0)
{
  for (int q = 0; q < 3; ++q)
  {
    this->Period[q] = box.Periodic[q] ? box.Size[q] : 0.0;
    this->Inverse[q] = box.Periodic[q] ? 1.0 / box.Size[q] : 0.0;
    this->Degrees -= box.Periodic[q] ? 1.0 : 0.0; // the centre of mass rests
  }
  const int spheres = static_cast<int>(pack.Size());
  for (int i = 0; i < spheres; ++i)
  {
    this->Spheres.push_back(
      { pack.Centre(i), {}, 0.0, pack.Radius[i], 0.0, largestGrowth * pack.Radius[i] });
    this->Place(i);
  }
  this->SetVelocities();
  for (int i = 0; i < spheres; ++i)
  {
    this->List(i);
  }
}

void HardSpheres::SetVelocities()
{
  for (std::size_t i = 0; i < this->Spheres.size(); ++i)
  {
    // Box and Muller's way to two normal numbers, and another
    const std::array<double, 3> u = UniformTriple(this->Chosen.Seed, RandomStream::Velocity, i, 0);
    const std::array<double, 3> w = UniformTriple(this->Chosen.Seed, RandomStream::Velocity, i, 1);
    const double first = std::sqrt(-2.0 * std::log(1.0 - u[0]));
    const double second = std::sqrt(-2.0 * std::log(1.0 - w[0]));
    this->Spheres[i].Velocity = { first * std::cos(2.0 * Pi * u[1]),
      first * std::sin(2.0 * Pi * u[1]), second * std::cos(2.0 * Pi * w[1]) };
  }
  this->SetTemperature();
}

void HardSpheres::SetTemperature()
{
  const double spheres = static_cast<double>(this->Spheres.size());
  Vector3 mean{};
  for (const Sphere& sphere : this->Spheres)
  {
    for (int q = 0; q < 3; ++q)
    {
      mean[q] += this->Box.Periodic[q] ? sphere.Velocity[q] / spheres : 0.0;
    }
  }
  double squares = 0.0;
  for (Sphere& sphere : this->Spheres)
  {
    for (int q = 0; q < 3; ++q)
    {
      sphere.Velocity[q] -= mean[q];
    }
    squares += Dot(sphere.Velocity, sphere.Velocity);
  }
  const double scale = this->Unit * std::sqrt(this->Degrees / squares);
  for (Sphere& sphere : this->Spheres)
  {
    for (double& v : sphere.Velocity)
    {
      v *= scale;
    }
  }
}

double HardSpheres::KineticEnergy() const
{
  double squares = 0.0;
  for (const Sphere& sphere : this->Spheres)
  {
    squares += Dot(sphere.Velocity, sphere.Velocity);
  }
  return 0.5 * squares / (this->Unit * this->Unit);
}

void HardSpheres::MoveTo(int i, double time)
{
  Sphere& sphere = this->Spheres[i];
  for (int q = 0; q < 3; ++q)
  {
    sphere.Place[q] += sphere.Velocity[q] * (time - sphere.Time);
  }
  sphere.Time = time;
}

void HardSpheres::MoveAllTo(double time)
{
  this->Time = time;
  for (int i = 0; i < static_cast<int>(this->Spheres.size()); ++i)
  {
    this->MoveTo(i, time);
  }
}

// Makes the place of the sphere that at which it is now
void HardSpheres::Place(int i)
{
  const Sphere& sphere = this->Spheres[i];
  const double radius = sphere.Final;
  this->Listed[i] = sphere.Place;
  this->Room[i] = this->Rooms.Of(radius);
  this->Reach[i] = radius + this->Room[i];
  this->Grid.Put(i, sphere.Place, this->Reach[i]);
}

// Finds the spheres near to the place of the sphere
void HardSpheres::List(int i)
{
  this->Grid.ForEachNear(i,
    [&](int j)
    {
      const Vector3 d = this->Between(this->Listed[i], this->Listed[j]);
      const double reach = this->Reach[i] + this->Reach[j];
      if (Dot(d, d) < reach * reach)
      {
        this->Near[i].push_back(j);
        this->Near[j].push_back(i);
      }
    });
}

void HardSpheres::Unlist(int i)
{
  for (int j : this->Near[i])
  {
    std::vector<int>& near = this->Near[j];
    *std::find(near.begin(), near.end(), i) = near.back();
    near.pop_back();
  }
  this->Near[i].clear();
}

// Finds the next event of a sphere: that it leaves its place, or meets a wall or another sphere. It
// is enough that one of two spheres knows of their collision.
double HardSpheres::Predict(int i)
{
  const Sphere& own = this->Spheres[i];
  const Vector3 gone = { own.Place[0] - this->Listed[i][0], own.Place[1] - this->Listed[i][1],
    own.Place[2] - this->Listed[i][2] };
  const double speed2 = Dot(own.Velocity, own.Velocity), along = Dot(gone, own.Velocity);
  const double left = this->Room[i] * this->Room[i] - Dot(gone, gone);
  double time = own.Time +
    (speed2 > 0.0
        ? std::max(0.0, (-along + std::sqrt(std::max(along * along + speed2 * left, 0.0))) / speed2)
        : Never);
  this->Partner[i] = LeavesPlace;
  for (int j : this->Near[i])
  {
    const Sphere& other = this->Spheres[j];
    const double since = own.Time - other.Time;
    const Vector3 place = { other.Place[0] + other.Velocity[0] * since,
      other.Place[1] + other.Velocity[1] * since, other.Place[2] + other.Velocity[2] * since };
    const Vector3 d = this->Between(own.Place, place);
    const Vector3 v = { other.Velocity[0] - own.Velocity[0], other.Velocity[1] - own.Velocity[1],
      other.Velocity[2] - own.Velocity[2] };
    const double contact = this->RadiusAt(own, own.Time) + this->RadiusAt(other, own.Time);
    const double growth = own.Growth + other.Growth;
    const double hit = own.Time +
      FirstRoot(
        Dot(v, v) - growth * growth, Dot(d, v) - contact * growth, Dot(d, d) - contact * contact);
    if (hit < time)
    {
      time = hit;
      this->Partner[i] = j;
    }
  }
  this->PredictWalls(i, time);
  this->Stamp[i] = this->Partner[i] >= 0 ? this->Count[this->Partner[i]] : 0;
  return time;
}

void HardSpheres::PredictWalls(int i, double& time)
{
  const Sphere& own = this->Spheres[i];
  for (int q = 0; q < 3; ++q)
  {
    const double radius = this->RadiusAt(own, own.Time);
    const double low = own.Place[q] - this->Box.Origin[q];
    for (int side = 0; side < 2 && !this->Box.Periodic[q]; ++side)
    {
      const double gap = (side == 0 ? low : this->Box.Size[q] - low) - radius;
      const double approach = own.Growth + (side == 0 ? -own.Velocity[q] : own.Velocity[q]);
      const double hit = approach > 0.0 ? own.Time + std::max(gap, 0.0) / approach : Never;
      if (hit < time)
      {
        time = hit;
        this->Partner[i] = HitsWall - (2 * q + side);
      }
    }
  }
}

void HardSpheres::PredictAgain(int i)
{
  this->Queue.SetTime(i, this->Predict(i));
}

void HardSpheres::PredictAll()
{
  std::vector<double> times(this->Spheres.size());
  for (int i = 0; i < static_cast<int>(this->Spheres.size()); ++i)
  {
    times[i] = this->Predict(i);
  }
  this->Queue.Assign(times);
}

// The part of the relative velocity along the line of centres, u, becomes 2 G - u, where G is the
// velocity at which the contact grows
void HardSpheres::Collide(int i, int j)
{
  Sphere &a = this->Spheres[i], &b = this->Spheres[j];
  const Vector3 d = this->Between(a.Place, b.Place);
  const double distance = Length(d);
  const Vector3 v = { b.Velocity[0] - a.Velocity[0], b.Velocity[1] - a.Velocity[1],
    b.Velocity[2] - a.Velocity[2] };
  const double u = Dot(v, d) / distance;
  const double change = a.Growth + b.Growth - u;
  for (int q = 0; q < 3; ++q)
  {
    a.Velocity[q] -= change * d[q] / distance;
    b.Velocity[q] += change * d[q] / distance;
  }
  ++this->Count[i];
  ++this->Count[j];
  ++this->Collisions;
  this->Virial += change * distance;
}

void HardSpheres::Bounce(int i, int face)
{
  Sphere& sphere = this->Spheres[i];
  double& v = sphere.Velocity[face / 2];
  const double sign = face % 2 == 0 ? 1.0 : -1.0;
  v = sign * (2.0 * sphere.Growth - sign * v);
  ++this->Count[i];
}

bool HardSpheres::IsJammed() const
{
  if (this->GrowthRate == 0.0)
  {
    return false;
  }
  // Near jamming P V / (N k T) is the inverse of the growth that is left, so that what is ten times
  // that away is out of reach
  const double grown = this->GrowthRate * (this->Time - this->Course.Before);
  const double wanted = this->GrowthRate * (this->Course.End - this->Time);
  return grown < 1e-7 || (this->Pressure > 1e4 && wanted * this->Pressure > 10.0);
}

void HardSpheres::Begin(double end, double collisions)
{
  // Two take part in each
  const double last =
    this->Collisions + collisions * static_cast<double>(this->Spheres.size()) / 2.0;
  this->Course = { end, last, this->Time, this->Collisions };
  this->Virial = 0.0;
  this->PredictAll();
}

// Returns whether there is another
bool HardSpheres::BeginRound()
{
  if (this->IsJammed())
  {
    return false;
  }
  this->Course.Before = this->Time;
  this->SetTemperature();
  this->PredictAll();
  return true;
}

HardSpheres::End HardSpheres::Run(const std::function<bool()>& carryOn)
{
  const auto spheres = static_cast<std::int64_t>(this->Spheres.size());
  std::int64_t round = this->Collisions + CollisionsOfRound * spheres;
  std::int64_t events = 0;
  while (true)
  {
    const int i = this->Queue.Earliest();
    const double time = this->Queue.TimeOf(i);
    if (time >= this->Course.End)
    {
      this->MoveAllTo(this->Course.End);
      return End::Done;
    }
    this->HandleEvent(i, time);
    if (this->Chosen.Exchange && this->Collisions >= this->Course.NextExchange)
    {
      this->Course.NextExchange = this->Collisions + CollisionsOfExchange * spheres;
      this->MoveAllTo(time);
      this->ExchangeRadii();
      this->PredictAll();
    }
    if (++events >= EventsOfQuestion * spheres)
    {
      events = 0;
      if (!carryOn())
      {
        this->MoveAllTo(time);
        return End::Stopped;
      }
    }
    if (this->Collisions >= round || this->Collisions >= this->Course.Last)
    {
      events = 0;
      round = this->Collisions + CollisionsOfRound * spheres;
      this->MoveAllTo(time);
      this->FindPressure(time - this->Course.Before);
      if (this->Collisions >= this->Course.Last)
      {
        return End::Done;
      }
      this->BetweenRounds = true;
      const bool goesOn = carryOn();
      this->BetweenRounds = false;
      if (!goesOn)
      {
        return End::Stopped;
      }
      if (!this->BeginRound())
      {
        return End::Jammed;
      }
    }
  }
}

// What the earliest event is of the sphere
void HardSpheres::HandleEvent(int i, double time)
{
  this->Time = time;
  this->MoveTo(i, time);
  const int partner = this->Partner[i];
  if (partner == LeavesPlace)
  {
    this->Unlist(i);
    this->Place(i);
    this->List(i);
  }
  else if (partner <= HitsWall)
  {
    this->Bounce(i, HitsWall - partner);
  }
  else if (this->Count[partner] == this->Stamp[i])
  {
    this->MoveTo(partner, time);
    this->Collide(i, partner);
    this->PredictAgain(partner);
  }
  this->PredictAgain(i);
}

void HardSpheres::FindPressure(double time)
{
  const double spheres = static_cast<double>(this->Spheres.size());
  const double kT = 2.0 * this->KineticEnergy() / this->Degrees * this->Unit * this->Unit;
  this->Pressure = time > 0.0 ? 1.0 + this->Virial / (3.0 * spheres * kT * time) : Never;
  this->Virial = 0.0;
}

HardSpheres::End HardSpheres::Grow(double growth, double rate, const std::function<bool()>& carryOn)
{
  this->GrowthRate = rate;
  for (Sphere& sphere : this->Spheres)
  {
    sphere.Growth = rate * sphere.Radius;
    sphere.Time = 0.0;
  }
  this->Begin((growth - 1.0) / rate, Never);
  return this->Finish(this->Run(carryOn));
}

HardSpheres::End HardSpheres::Equilibrate(double collisions, const std::function<bool()>& carryOn)
{
  this->Begin(Never, collisions);
  return this->Finish(this->Run(carryOn));
}

HardSpheres::End HardSpheres::Resume(const std::function<bool()>& carryOn)
{
  return this->Finish(this->BeginRound() ? this->Run(carryOn) : End::Jammed);
}

// Makes the radii those that the spheres have now, which do not grow
HardSpheres::End HardSpheres::Finish(End end)
{
  for (Sphere& sphere : this->Spheres)
  {
    sphere.Radius = this->RadiusAt(sphere, this->Time);
    sphere.Growth = 0.0;
    sphere.Time = 0.0;
  }
  this->Growth = this->GetGrowth();
  this->Time = this->GrowthRate = 0.0;
  return end;
}

SpherePack HardSpheres::GetPack() const
{
  SpherePack pack;
  for (const Sphere& sphere : this->Spheres)
  {
    pack.X.push_back(sphere.Place[0]);
    pack.Y.push_back(sphere.Place[1]);
    pack.Z.push_back(sphere.Place[2]);
    pack.Radius.push_back(sphere.Radius);
  }
  WrapIntoBox(pack, this->Box);
  return pack;
}
}
