// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
// What the Sphere Pack Reader makes of texts, and what it says, on rank 0, which alone reads
#include "Refusals.h"

#include "vtkRUCSpherePackReader.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>

namespace
{
class Reading
{
public:
  explicit Reading(
    const std::string& text, const std::function<void(vtkRUCSpherePackReader*)>& configure = {})
  {
    const std::string name = "reading_np" + std::to_string(NumberOfRanks()) + ".csv";
    std::ofstream(name, std::ios::binary) << text;
    this->Reader->SetController(nullptr); // rank 0 alone
    this->Reader->SetFileName(name.c_str());
    if (configure)
    {
      configure(this->Reader);
    }
    this->Reader->Update();
    std::remove(name.c_str());
    EXPECT_TRUE(this->Error.Texts.empty()) << this->Error.Texts.front();
  }
  vtkPolyData* Output() { return this->Reader->GetOutput(); }
  const std::vector<std::string>& Told() const { return this->Warning.Texts; }

  vtkNew<vtkRUCSpherePackReader> Reader;

private:
  Errors Error{ this->Reader };
  Warnings Warning{ this->Reader };
};

void InBoxOfTen(vtkRUCSpherePackReader* reader)
{
  reader->SetBoxSize(10, 10, 10);
  reader->SetBoxPeriodic(1, 1, 1);
}
}

TEST(Reading, CentresOutsideAPeriodicBox)
{
  const struct
  {
    double X, Place;
    bool Told;
  } cases[] = { { -1e-4, 9.9999, true }, { -2e-6, 9.999998, true }, { 23.5, 3.5, true },
    { 10.0, 10.0, false }, { -5e-9, -5e-9, false } };
  for (std::size_t n = 0; Rank() == 0 && n < std::size(cases); ++n)
  {
    Reading reading(
      "x,y,z,radius\n" + std::to_string(cases[n].X) + ",5,5,1\n5,5,5,1\n", InBoxOfTen);
    ASSERT_EQ(reading.Output()->GetNumberOfPoints(), 2);
    EXPECT_NEAR(reading.Output()->GetPoint(0)[0], cases[n].Place, 1e-8);
    ASSERT_EQ(reading.Told().size(), cases[n].Told ? 1u : 0u);
    if (cases[n].Told)
    {
      ExpectParts(reading.Told()[0], { "Sphere Pack Reader: 1 of 2 centres lay outside" });
    }
  }
}

TEST(Reading, PeriodicCopiesInABoxFarLongerThanWide)
{
  if (Rank() == 0)
  {
    std::string text = "x,y,z,radius\n";
    for (int i = 0; i < 3000; ++i)
    {
      const std::array<double, 3> u = ruc::UniformTriple(7, ruc::RandomStream::CellCentres, i);
      text += std::to_string(3e7 * u[0]) + ',' + std::to_string(u[1]) + ',' + std::to_string(u[2]) +
        ",0.01\n";
      text += i == 2999 ? std::to_string(3e7 * u[0]) + ',' + std::to_string(u[1] + 1.0) + ',' +
          std::to_string(u[2]) + ",0.01\n"
                        : "";
    }
    Reading reading(text,
      [](auto* reader)
      {
        reader->SetBoxSize(1e8, 1, 1);
        reader->SetBoxPeriodic(1, 1, 1);
      });
    EXPECT_EQ(reading.Output()->GetNumberOfPoints(), 3000);
  }
}

TEST(Reading, IsToldInASummary)
{
  if (Rank() != 0)
  {
    return;
  }
  Reading reading("x,y,z,radius\n1,1,1,1\n6,5,4,2\n3,7,9,1\n",
    [](auto* reader)
    {
      InBoxOfTen(reader);
      reader->SetLengthUnit("mm");
    });
  EXPECT_TRUE(reading.Told().empty());
  EXPECT_EQ(std::string(reading.Reader->GetSummary()),
    "table: 3 spheres of diameter 2 to 4 mm, centres over 5 x 6 x 8 mm from (1, 1, 1), periodic "
    "box "
    "10 x 10 x 10 by Box Size, fraction 0.0418879 of the window.");
  const Errors errors(reading.Reader);
  reading.Reader->SetFileName("no such file.csv");
  reading.Reader->Update();
  EXPECT_EQ(std::string(reading.Reader->GetSummary()), "");
}

TEST(Reading, UnitsThatDoNotFitAreToldOnce)
{
  if (Rank() == 0)
  {
    // The centres are in metres, the box is in micrometres
    Reading reading(
      "x,y,z,radius\n1e-6,1e-6,1e-6,1e-6\n6e-6,5e-6,4e-6,1e-6\n3e-6,7e-6,9e-6,1e-6\n", InBoxOfTen);
    ASSERT_EQ(reading.Told().size(), 1u);
    ExpectParts(reading.Told()[0], { "Sphere Pack Reader: the centres extend over", "Scale" });
  }
}

TEST(Reading, ColumnsOfTextBlockNothing)
{
  if (Rank() == 0)
  {
    Reading reading("id,x,y,z,radius,mode\na7,1,1,1,1,coarse\nb8,6,5,4,0,fine\n");
    EXPECT_EQ(reading.Output()->GetNumberOfPoints(), 2);
    EXPECT_EQ(reading.Output()->GetPointData()->GetArray("Mode"), nullptr);
    EXPECT_EQ(reading.Output()->GetPointData()->GetArray("Id")->GetTuple1(1), 1.0) << "the place";
    ASSERT_EQ(reading.Told().size(), 3u);
    ExpectParts(reading.Told()[0], { "('mode') is left out", "'coarse' in line 2" });
    ExpectParts(reading.Told()[1], { "('id') is left out", "'a7' in line 2" });
    ExpectParts(reading.Told()[2], { "1 of 2 radii are 0" });
  }
}
