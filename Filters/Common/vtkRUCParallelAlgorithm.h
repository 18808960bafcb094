// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCParallelAlgorithm
 * @brief What all filters of this plugin have in common: ranks and errors
 *
 * Whatever is wrong with the input or a property is found on all ranks alike and reported once, in
 * one line. Every output is then empty but for the field data `Refusal`, which gives the reason,
 * and no rank hangs. An input with such field data is refused without a message, since the cause
 * was reported where it was found. A filter with several outputs runs once for all of them.
 */
#ifndef vtkRUCParallelAlgorithm_h
#define vtkRUCParallelAlgorithm_h

#include "RUCCommonModule.h"

#include "vtkDataObjectAlgorithm.h"

#include <string>
#include <utility>
#include <vector>

class RankCommunicator;
class vtkMultiProcessController;

class RUCCOMMON_EXPORT vtkRUCParallelAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkRUCParallelAlgorithm, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /** Returns the label, with which messages begin. */
  std::string GetObjectDescription() const override { return this->GetLabel(); }

  ///@{
  /**
   * The ranks that work together. They are those of the global controller unless another is set.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const { return this->Controller; }
  ///@}

protected:
  vtkRUCParallelAlgorithm();
  ~vtkRUCParallelAlgorithm() override;

  /** The name in messages and progress, which is the label in the menu. */
  virtual const char* GetLabel() const = 0;

  /**
   * Fills the outputs, on all ranks together. Throws std::invalid_argument, the same on every rank,
   * for bad input; the filter then does not run again before its input or a property changes. The
   * outputs are empty at the start and are emptied again after an error. A table is filled on rank
   * 0 alone; the other ranks then get its columns, without rows.
   */
  virtual void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) = 0;

  /**
   * Throws std::invalid_argument if a port has several inputs. The pipeline lets these in only if
   * the port is repeatable; otherwise the filter would never run, and its outputs would stay as
   * they were.
   */
  static void RequireOne(vtkInformationVector* inputsOfPort, const char* port, const char* what);

  int RequestDataObject(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) final;

private:
  vtkRUCParallelAlgorithm(const vtkRUCParallelAlgorithm&) = delete;
  void operator=(const vtkRUCParallelAlgorithm&) = delete;

  // The filter and its inputs, with the times of their last changes
  using Cause = std::vector<std::pair<const void*, vtkMTimeType>>;
  Cause FindCause(vtkInformationVector** inputs);
  // Returns whether the run need not be tried, because the same one, or an input, was refused.
  // Collective
  bool WasTold(vtkInformationVector** inputs, RankCommunicator& ranks);
  // Leaves nothing in the outputs but the reason, if there is one
  void ClearOutputs(vtkInformationVector* outputs);

  vtkMultiProcessController* Controller = nullptr;
  Cause Refused;       // the cause of the last run, if that was refused
  std::string Refusal; // the reason
};

#endif
