// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCSpherePackWriter
 * @brief Writes a sphere pack in the format of another program
 *
 * The extension of the file's name decides on the format (ruc::FormatOfExtension): `dump`,
 * `lammpstrj` and `data` of LAMMPS and LIGGGHTS, `extxyz`, `xyzd` of Baranau's programs with a file
 * .nfo beside it, `yade` or `txt` of YADE, and the tables `csv` and `spheres`. Numbers have all
 * digits.
 *
 * Input: a sphere pack with `Radius` (PackInput), on whatever ranks; without ghosts. The type of a
 * sphere is its `Mode`, else its `Type`, else 1. Spheres are written in the order of their `Id`, so
 * that the file is the same for any number of ranks; where ids are missing or repeat, they are the
 * places in the order of ruc::SortCanonically. The box is that of the pack's own window; without
 * one it is that of the spheres' bounds, where a format must have one.
 *
 * Several packs become the frames of one file, if the format holds several: the time steps of the
 * input with WriteAllTimeSteps, and the cells of Unit Cell Reconstruction in one multiblock.
 *
 * Rank 0 gathers one frame at a time and writes it. The file takes the place of an old one once it
 * is whole (NewFile). A unit of length that the format cannot tell is lost with a warning.
 */
#ifndef vtkRUCSpherePackWriter_h
#define vtkRUCSpherePackWriter_h

#include "RUCReadersModule.h"
#include "vtkRUCParallelAlgorithm.h"

#include <memory>
#include <string>
#include <vector>

class NewFile;
class vtkAbstractArray;
namespace ruc
{
struct FramePack;
struct PackFormat;
}

class RUCREADERS_EXPORT vtkRUCSpherePackWriter : public vtkRUCParallelAlgorithm
{
public:
  static vtkRUCSpherePackWriter* New();
  vtkTypeMacro(vtkRUCSpherePackWriter, vtkRUCParallelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to write, on the machine of rank 0. */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}
  ///@{
  /** The density of the spheres, in files that hold one; > 0. Default: 1. */
  vtkSetMacro(Density, double);
  vtkGetMacro(Density, double);
  ///@}
  ///@{
  /** Whether all time steps of the input are written, not only the present one. Default: off. */
  vtkSetMacro(WriteAllTimeSteps, bool);
  vtkGetMacro(WriteAllTimeSteps, bool);
  ///@}

  /** Writes the file, on all ranks together. Returns 1, or 0 after an error. */
  int Write();

protected:
  vtkRUCSpherePackWriter();
  ~vtkRUCSpherePackWriter() override;
  const char* GetLabel() const override { return "Sphere Pack Writer"; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;

private:
  vtkRUCSpherePackWriter(const vtkRUCSpherePackWriter&) = delete;
  void operator=(const vtkRUCSpherePackWriter&) = delete;

  /** Returns the times of the frames to write; none for the present one. Collective. */
  std::vector<double> FindTimes(RankCommunicator& ranks);
  const ruc::PackFormat& FindFormat() const;
  /** Returns why the input is empty, if a filter of this plugin has refused to make it. */
  vtkAbstractArray* FindRefusal();
  /** Appends a frame to the file. On rank 0 alone, as the next. */
  void Append(const ruc::FramePack& pack);
  /** Puts the file, and the one beside it, in their places. */
  void KeepFiles();

  std::string FileName;
  double Density = 1.0;
  bool WriteAllTimeSteps = false;
  // Of a call of Write
  std::vector<double> Times;
  std::size_t Step = 0;  // of Times
  bool Gathered = false; // whether Execute has come to its end
  std::size_t Frames = 0;
  // On rank 0, once there is a frame
  std::unique_ptr<NewFile> File;
  std::string Info;
};

#endif
