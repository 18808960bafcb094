// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadRanks.h"

#include "ruc/Base/Communicator.h"

#include <gtest/gtest.h>

namespace
{
// The same claims on one rank without any, and on one to four of them
void OnRanks(const std::function<void(ruc::Communicator&)>& work)
{
  ruc::Communicator serial;
  work(serial);
  for (int size = 1; size <= 4; ++size)
  {
    oracle::ThreadRanks::Run(size, work);
  }
}

// As many numbers as the number of the rank, so none on rank 0
std::vector<double> NumbersOf(int rank)
{
  return std::vector<double>(rank, rank + 0.5);
}
}

TEST(Communicator, BroadcastsFromAnyRank)
{
  OnRanks(
    [](ruc::Communicator& ranks)
    {
      for (int root = 0; root < ranks.Size(); ++root)
      {
        std::vector<double> numbers = NumbersOf(ranks.Rank());
        ranks.Broadcast(numbers, root);
        EXPECT_EQ(numbers, NumbersOf(root));
      }
    });
}

TEST(Communicator, GathersOneValueARank)
{
  OnRanks(
    [](ruc::Communicator& ranks)
    {
      const std::vector<std::vector<double>> all = ranks.AllGather(NumbersOf(ranks.Rank()));
      std::vector<double> flat;
      ASSERT_EQ(all.size(), ranks.Size());
      for (int rank = 0; rank < ranks.Size(); ++rank)
      {
        EXPECT_EQ(all[rank], NumbersOf(rank));
        flat.insert(flat.end(), all[rank].begin(), all[rank].end());
      }
      EXPECT_EQ(ranks.Concatenate(NumbersOf(ranks.Rank())), flat);
    });
}

TEST(Communicator, CarriesToEveryRankWhatIsMeantForIt)
{
  OnRanks(
    [](ruc::Communicator& ranks)
    {
      std::vector<std::string> outgoing;
      for (int to = 0; to < ranks.Size(); ++to)
      {
        outgoing.push_back(std::string(ranks.Rank() * to, 'x') + std::to_string(ranks.Rank()));
      }
      const std::vector<std::string> incoming = ranks.AllToAll(outgoing);
      ASSERT_EQ(incoming.size(), ranks.Size());
      for (int from = 0; from < ranks.Size(); ++from)
      {
        EXPECT_EQ(incoming[from], std::string(from * ranks.Rank(), 'x') + std::to_string(from));
      }
    });
}

TEST(Communicator, GathersBlocksThatRanksWorkedOutInTurn)
{
  OnRanks(
    [](ruc::Communicator& ranks)
    {
      constexpr std::size_t blocks = 7;
      const auto begin = [](std::size_t n) { return n * (n + 1) / 2; }; // of n + 1 numbers each
      std::vector<double> values(begin(blocks), -1.0);
      for (std::size_t n = ranks.Rank(); n < blocks; n += ranks.Size())
      {
        std::fill(values.begin() + begin(n), values.begin() + begin(n + 1), n);
      }
      ranks.AllGatherInTurn(values.data(), blocks, begin);
      for (std::size_t n = 0; n < blocks; ++n)
      {
        for (std::size_t place = begin(n); place < begin(n + 1); ++place)
        {
          EXPECT_EQ(values[place], n);
        }
      }
    });
}

// 1 + 1e-16 + 1e-16 + 1e-16 is 1 from the left, but not from the right
TEST(Communicator, SumsDoublesInTheOrderOfRanks)
{
  OnRanks(
    [](ruc::Communicator& ranks)
    {
      double values[2] = { ranks.Rank() == 0 ? 1.0 : 1e-16, double(ranks.Rank()) };
      ranks.Sum(values, 2);
      EXPECT_EQ(values[0], 1.0);
      EXPECT_EQ(values[1], ranks.Size() * (ranks.Size() - 1) / 2);
    });
}

TEST(Communicator, TellsTheLowestRankAndItsText)
{
  OnRanks(
    [](ruc::Communicator& ranks)
    {
      EXPECT_EQ(ranks.LowestRank(false), ranks.Size());
      EXPECT_EQ(ranks.LowestRank(true), 0);
      EXPECT_EQ(ranks.FirstText(""), "");
      const int last = ranks.Size() - 1;
      EXPECT_EQ(ranks.LowestRank(ranks.Rank() == last), last);
      EXPECT_EQ(ranks.FirstText(ranks.Rank() == last ? "last" : ""), "last");
      EXPECT_EQ(ranks.FirstText(std::to_string(ranks.Rank())), "0");
      EXPECT_NO_THROW(ranks.ThrowIfAny(""));
      EXPECT_THROW(ranks.ThrowIfAny(ranks.Rank() == last ? "fault" : ""), std::invalid_argument);
    });
}
