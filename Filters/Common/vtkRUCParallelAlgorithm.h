// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCParallelAlgorithm
 * @brief What all filters of this plugin have in common: ranks and errors
 *
 * Whatever is wrong with the input or a property is found on all ranks alike, reported once, and
 * leaves every output empty; no rank hangs. A filter with several outputs runs once for all of
 * them.
 */
#ifndef vtkRUCParallelAlgorithm_h
#define vtkRUCParallelAlgorithm_h

#include "RUCCommonModule.h"

#include "vtkDataObjectAlgorithm.h"

class RankCommunicator;
class vtkMultiProcessController;

class RUCCOMMON_EXPORT vtkRUCParallelAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkRUCParallelAlgorithm, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

  /** The name in error messages and progress, which is the label in the menu. */
  virtual const char* GetLabel() const = 0;

  /**
   * Fills the outputs, on all ranks together. Throws std::invalid_argument, the same on every rank,
   * for bad input. The outputs are empty at the start and are emptied again after an error. A table
   * is filled on rank 0 alone; the other ranks then get its columns, without rows.
   */
  virtual void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) = 0;

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

  vtkMultiProcessController* Controller = nullptr;
};

#endif
