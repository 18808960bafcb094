// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCEstimatedAlgorithm
 * @brief A filter that tells what a run will take, and refuses one that takes too much memory
 */
#ifndef vtkRUCEstimatedAlgorithm_h
#define vtkRUCEstimatedAlgorithm_h

#include "vtkRUCParallelAlgorithm.h"

#include <optional>
#include <string>

namespace ruc
{
struct Estimate;
}

class RUCCOMMON_EXPORT vtkRUCEstimatedAlgorithm : public vtkRUCParallelAlgorithm
{
public:
  vtkTypeMacro(vtkRUCEstimatedAlgorithm, vtkRUCParallelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The memory that every rank may use, in megabytes of 10^6 bytes. A run whose estimate
   * (GetEstimatedMemory) is above that on any rank is refused on all ranks before it begins.
   * Default: 4000.
   */
  vtkSetMacro(MemoryLimit, double);
  vtkGetMacro(MemoryLimit, double);
  ///@}

  /**
   * What a run with the properties as they are would take, on an even pack: seconds, with the work
   * shared by all ranks and their threads, and megabytes of 10^6 bytes on every rank. It is told
   * from the input as it was last updated on this rank, without any work and without asking other
   * ranks, and so to a factor of three (Core/Base/Estimate.h). It is 0 where it is not known:
   * without input, for properties out of range, and for filters that do not tell.
   */
  double GetEstimatedTime();
  virtual double GetEstimatedMemory();
  /**
   * About what 0 stands for in properties that are then automatic, such as "Maximum Lag 394". It is
   * empty where none of them is 0, and where that is not known.
   */
  const char* GetAutomaticValues();

protected:
  vtkRUCEstimatedAlgorithm() = default;
  ~vtkRUCEstimatedAlgorithm() override = default;

  /**
   * Returns the estimates, or none where they are not known. It may throw
   * std::invalid_argument for what a run would refuse, which then has no estimates either.
   */
  virtual std::optional<ruc::Estimate> MakeEstimate();
  /**
   * Returns what a region to sample adds to the estimates, as far as it is known; nothing by
   * default.
   */
  virtual ruc::Estimate EstimateRegion();
  /**
   * The part of the estimated memory that is held against MemoryLimit before a run; all of it by
   * default.
   */
  virtual double GetMemoryToCheck() { return this->GetEstimatedMemory(); }
  /**
   * Throws std::invalid_argument, the same on every rank, where a run takes more than MemoryLimit
   * on any rank. `megabytes` is what it takes on this one. Collective.
   */
  void RequireMemory(double megabytes, RankCommunicator& ranks) const;

private:
  vtkRUCEstimatedAlgorithm(const vtkRUCEstimatedAlgorithm&) = delete;
  void operator=(const vtkRUCEstimatedAlgorithm&) = delete;

  std::optional<ruc::Estimate> FindEstimate();

  double MemoryLimit = 4000.0;
  std::string AutomaticValues;
};

#endif
