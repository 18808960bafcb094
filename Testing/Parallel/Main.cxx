// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Runs every test of a program on all ranks together. A test that fails on one rank fails on all,
 * so that every rank ends with the same exit code. Rank 0 prints as GoogleTest does; the others
 * print their failures alone.
 */
#include "vtkMPIController.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <iostream>

#ifdef __SANITIZE_ADDRESS__
/** Libraries stay loaded, so that what Open MPI's have left behind is known by their names. */
extern "C" __attribute__((visibility("default"))) int dlclose(void*)
{
  return 0;
}
#endif

namespace
{
class OtherRanks : public testing::EmptyTestEventListener
{
  void OnTestPartResult(const testing::TestPartResult& result) override
  {
    if (result.failed())
    {
      const auto* test = testing::UnitTest::GetInstance()->current_test_info();
      std::cerr << "rank " << vtkMultiProcessController::GetGlobalController()->GetLocalProcessId()
                << ", " << (test ? test->name() : "no test") << ": " << result.file_name() << ":"
                << result.line_number() << ": " << result.message() << std::endl;
    }
  }
};

class AgreeOnFailure : public testing::EmptyTestEventListener
{
  void OnTestEnd(const testing::TestInfo& test) override
  {
    const int failed = test.result()->Failed();
    int somewhere = 0;
    vtkMultiProcessController::GetGlobalController()->AllReduce(
      &failed, &somewhere, 1, vtkCommunicator::MAX_OP);
    if (somewhere && !failed)
    {
      ADD_FAILURE() << "it failed on another rank";
    }
  }
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
