// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RankCommunicator.h"
#include "RankSignal.h"

#include "Oracles.h"

#include "vtkDummyController.h"
#include "vtkNew.h"
#include "vtkSocketController.h"

// A program without MPI, such as a Python interpreter that loads VTK
TEST(RankCommunicator, OneRankNeedsNoMpi)
{
  vtkNew<vtkDummyController> dummy;
  for (vtkMultiProcessController* controller : { static_cast<vtkMultiProcessController*>(nullptr),
         static_cast<vtkMultiProcessController*>(dummy) })
  {
    RankCommunicator ranks(controller);
    EXPECT_NO_THROW(ranks.RequireMpi());
    EXPECT_EQ(ranks.Size(), 1);
    EXPECT_EQ(ranks.AllGather(std::string("own")), std::vector<std::string>{ "own" });
    EXPECT_EQ(ranks.Split(0)->Size(), 1);
    RankSignal signal(ranks);
    signal.Close([]() { return 1; });
    EXPECT_EQ(signal.Heard(), 0);
  }
}

TEST(RankCommunicator, ManyRanksWithoutMpiAreRefused)
{
  vtkNew<vtkSocketController> sockets;
  const RankCommunicator ranks(sockets);
  EXPECT_SAYS(
    ranks.RequireMpi(), "Several ranks require MPI, got 2 ranks of a vtkSocketController.");
}
