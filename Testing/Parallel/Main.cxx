// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Runs every test of a program on all ranks together. A test that fails on one rank fails on all,
 * so that every rank ends with the same exit code; where the others wait for what it left out, all
 * are ended. Rank 0 prints as GoogleTest does; the others
 * print their failures alone.
 */
#include "vtkMPIController.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <mpi.h>

#include <chrono>
#include <iostream>
#include <string>
#include <thread>

#ifdef __SANITIZE_ADDRESS__
/** Libraries stay loaded, so that what Open MPI's have left behind is known by their names. */
extern "C" __attribute__((visibility("default"))) int dlclose(void*)
{
  return 0;
}
#endif

namespace
{
// GoogleTest may not be asked for the test within OnTestPartResult: it would wait for itself
class OtherRanks : public testing::EmptyTestEventListener
{
  void OnTestStart(const testing::TestInfo& test) override { this->Name = test.name(); }
  void OnTestPartResult(const testing::TestPartResult& result) override
  {
    if (result.failed())
    {
      std::cerr << "rank " << vtkMultiProcessController::GetGlobalController()->GetLocalProcessId()
                << ", " << this->Name << ": " << result.file_name() << ":" << result.line_number()
                << ": " << result.message() << std::endl;
    }
  }

  std::string Name = "no test";
};

// By messages of their own, which do not meet those that ranks still wait for within the test
class AgreeOnFailure : public testing::EmptyTestEventListener
{
public:
  AgreeOnFailure() { MPI_Comm_dup(MPI_COMM_WORLD, &this->Ranks); }

private:
  void OnTestEnd(const testing::TestInfo& test) override
  {
    const int failed = test.result()->Failed();
    int somewhere = 0;
    MPI_Request request;
    MPI_Iallreduce(&failed, &somewhere, 1, MPI_INT, MPI_MAX, this->Ranks, &request);
    const auto start = std::chrono::steady_clock::now();
    for (int all = 0; !all; MPI_Test(&request, &all, MPI_STATUS_IGNORE))
    {
      // A rank that left the test early may be what the others wait for, for ever
      if (failed && std::chrono::steady_clock::now() - start > std::chrono::seconds(20))
      {
        std::cerr << test.name() << " failed on a rank, and the others do not end it" << std::endl;
        MPI_Abort(MPI_COMM_WORLD, 1);
      }
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
    if (somewhere && !failed)
    {
      ADD_FAILURE() << "it failed on another rank";
    }
  }

  MPI_Comm Ranks; // ended by MPI_Finalize, as GoogleTest ends its listeners later
};
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  testing::InitGoogleTest(&argc, argv);

  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  if (controller->GetLocalProcessId() > 0)
  {
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new OtherRanks);
  }
  // The ends of tests are told to the last listener first: what it adds is printed by the others
  listeners.Append(new AgreeOnFailure);
  const int result = RUN_ALL_TESTS();

  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return result;
}
