// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace ruc
{
/** Finds the earliest of the times of 0…n - 1, each of which may change: a binary heap. */
class EventQueue
{
public:
  /** Begins anew with these times. */
  void Assign(const std::vector<double>& times)
  {
    this->Times = times;
    const int count = static_cast<int>(times.size());
    this->Heap.resize(count);
    this->PlaceOf.resize(count);
    for (int n = 0; n < count; ++n)
    {
      this->Heap[n] = this->PlaceOf[n] = n;
    }
    for (int place = count / 2; place-- > 0;)
    {
      this->Sink(place);
    }
  }

  int Earliest() const { return this->Heap.front(); }
  double TimeOf(int n) const { return this->Times[n]; }

  void SetTime(int n, double time)
  {
    this->Times[n] = time;
    this->Rise(this->PlaceOf[n]);
    this->Sink(this->PlaceOf[n]);
  }

private:
  void Set(int place, int n)
  {
    this->Heap[place] = n;
    this->PlaceOf[n] = place;
  }

  void Rise(int place)
  {
    const int n = this->Heap[place];
    while (place > 0 && this->Times[this->Heap[(place - 1) / 2]] > this->Times[n])
    {
      this->Set(place, this->Heap[(place - 1) / 2]);
      place = (place - 1) / 2;
    }
    this->Set(place, n);
  }

  void Sink(int place)
  {
    const int n = this->Heap[place], count = static_cast<int>(this->Heap.size());
    for (int child = 2 * place + 1; child < count; child = 2 * place + 1)
    {
      if (child + 1 < count && this->Times[this->Heap[child + 1]] < this->Times[this->Heap[child]])
      {
        ++child;
      }
      if (this->Times[this->Heap[child]] >= this->Times[n])
      {
        break;
      }
      this->Set(place, this->Heap[child]);
      place = child;
    }
    this->Set(place, n);
  }

  std::vector<double> Times;
  std::vector<int> Heap, PlaceOf;
};
}
