// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRUCRawImageWriter
 * @brief Writes the voxels of an image as plain numbers, for solvers
 *
 * Input: an image with axes along x, y and z, in pieces on whatever ranks, without ghosts. The
 * voxels are its cells, or boxes of its spacing around its points, whichever have the array. They
 * are written x running fastest, in the type of the array, after the text that `Header` asks for
 * (ruc::WriteHeader).
 *
 * Every rank writes its voxels at their places in one file, so no rank holds more of the image than
 * its piece, and the file is the same for any number of ranks. It takes the place of an old one
 * once it is whole (NewFile). All ranks must see the folder of the file.
 */
#ifndef vtkRUCRawImageWriter_h
#define vtkRUCRawImageWriter_h

#include "RUCImagesModule.h"
#include "vtkRUCParallelAlgorithm.h"

#include <string>

namespace ruc
{
enum class RawHeader;
struct RawImage;
}

struct ImagePiece;
class NewFile;

class RUCIMAGES_EXPORT vtkRUCRawImageWriter : public vtkRUCParallelAlgorithm
{
public:
  static vtkRUCRawImageWriter* New();
  vtkTypeMacro(vtkRUCRawImageWriter, vtkRUCParallelAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Headers
  {
    BY_EXTENSION = 0,
    META_IMAGE = 1,
    AMITEX_VTK = 2,
    NONE = 3
  };
  enum ByteOrders
  {
    LITTLE_ENDIAN_BYTES = 0,
    BIG_ENDIAN_BYTES = 1
  };

  ///@{
  /** The file to write. */
  vtkSetStdStringFromCharMacro(FileName);
  vtkGetCharFromStdStringMacro(FileName);
  ///@}
  ///@{
  /**
   * The text before the voxels. That of MetaImage goes into a file of its own where the name ends
   * by mhd; the voxels are then in a file .raw beside it. Default: BY_EXTENSION, MetaImage for mha
   * and mhd, AMITEX VTK for vtk and none for others.
   */
  vtkSetMacro(Header, int);
  vtkGetMacro(Header, int);
  ///@}
  ///@{
  /**
   * The array to write, of one component. Default: empty, which stands for `Phase`, else the first
   * array of the cells, else of the points.
   */
  vtkSetStdStringFromCharMacro(ImageArray);
  vtkGetCharFromStdStringMacro(ImageArray);
  ///@}
  ///@{
  /** Other values in place of those of the array (ruc::ValueMap). Default: empty. */
  vtkSetStdStringFromCharMacro(Values);
  vtkGetCharFromStdStringMacro(Values);
  ///@}
  ///@{
  /** The order of the bytes of a number, where the header leaves a choice. Default: little-endian.
   */
  vtkSetMacro(ByteOrder, int);
  vtkGetMacro(ByteOrder, int);
  ///@}

  /** Writes the file, on all ranks together. Returns 1, or 0 after an error. */
  int Write();

protected:
  vtkRUCRawImageWriter();
  ~vtkRUCRawImageWriter() override = default;
  const char* GetLabel() const override { return "Raw Image Writer"; }
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, RankCommunicator& ranks) override;

private:
  vtkRUCRawImageWriter(const vtkRUCRawImageWriter&) = delete;
  void operator=(const vtkRUCRawImageWriter&) = delete;

  ruc::RawHeader FindHeader() const;
  bool HasExtension(const char* extension) const;
  ruc::RawImage DescribeImage(const ImagePiece& piece, ruc::RawHeader header) const;
  // Puts the voxels, and the header if it is a file of its own, in their places. On rank 0 alone
  void KeepFiles(NewFile& voxels, const std::string& header) const;

  std::string FileName;
  int Header = BY_EXTENSION;
  std::string ImageArray;
  std::string Values;
  int ByteOrder = LITTLE_ENDIAN_BYTES;
  bool Written = false; // whether Execute has come to its end
};

#endif
