// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Packs of others, which are not part of this project: in the folder RUC_THIRD_PARTY_DATA and in
// formats beside it. What each must give is told by its source, not by this code.
#include "FormatFiles.h"

#include <map>

namespace
{
using ruc::FramePack;

// The file, or an empty text where the data is not there
std::string FileOfOthers(const std::string& name)
{
  const char* const folder = std::getenv("RUC_THIRD_PARTY_DATA");
  if (!folder)
  {
    return {};
  }
  const std::string file = std::string(folder) + "/" + name;
  return std::ifstream(file).good() ? file : std::string();
}

#define FILE_OF_OTHERS(file, name)                                                                 \
  const std::string file = FileOfOthers(name);                                                     \
  if (file.empty())                                                                                \
  {                                                                                                \
    GTEST_SKIP() << "RUC_THIRD_PARTY_DATA is not set, or without " << (name);                      \
  }

double Fraction(const FramePack& pack)
{
  double volume = 0.0;
  for (double r : pack.Pack.Radius)
  {
    volume += 4.0 / 3.0 * oracle::Pi * r * r * r;
  }
  return volume / pack.Box->Volume();
}

std::pair<double, double> Radii(const FramePack& pack)
{
  const auto [least, most] = std::minmax_element(pack.Pack.Radius.begin(), pack.Pack.Radius.end());
  return { *least, *most };
}
}

TEST(FilesOfOthers, Voro)
{
  FILE_OF_OTHERS(cube, "../formats/others/voro_pack_ten_cube.gz")
  FILE_OF_OTHERS(poly, "../formats/others/voro_pack_six_cube_poly.gz")
  EXPECT_SAYS(formats::OpenFile(cube).Pack(), "The first column counts the rows");
  auto open = formats::OpenFile(cube);
  open.Settings.Columns = "id,x,y,z";
  ruc::PackSettings radius;
  radius.UniformRadius = 0.5;
  EXPECT_EQ(open.Pack(0, radius).Pack.Size(), 1000u);
  EXPECT_EQ(open.Pack(0, radius).Pack.Id.front(), 1);
  EXPECT_SAYS(formats::OpenFile(poly).Pack(), "5 columns without names");
  auto many = formats::OpenFile(poly);
  many.Settings.Columns = "id,x,y,z,r";
  const FramePack pack = many.Pack();
  EXPECT_EQ(pack.Pack.Size(), 159u);
  EXPECT_NEAR(Radii(pack).first, 0.251094, 1e-6);
  EXPECT_NEAR(Radii(pack).second, 0.746344, 1e-6);
}

TEST(FilesOfOthers, Yade)
{
  FILE_OF_OTHERS(geometry, "../formats/others/yade_LSMGenGeo.geo")
  FILE_OF_OTHERS(text, "../formats/others/yade_5cmEdge_1mm.spheres")
  const FramePack pack = formats::OpenFile(geometry).Pack();
  EXPECT_EQ(pack.Pack.Size(), 387u);
  EXPECT_NEAR(Radii(pack).first, 0.2000305, 1e-7);
  EXPECT_NEAR(Radii(pack).second, 0.6985269, 1e-7);
  EXPECT_FALSE(pack.BoxIsWindow);
  const FramePack spheres = formats::OpenFile(text).Pack();
  EXPECT_EQ(spheres.Pack.Size(), 210u);
  EXPECT_EQ(Radii(spheres), std::make_pair(0.004, 0.004));
}

TEST(FilesOfOthers, LiggghtsAndMercury)
{
  FILE_OF_OTHERS(data, "../formats/others/liggghts_hydrogel.data")
  FILE_OF_OTHERS(mercury, "../formats/others/mercury_combinedfiles.data")
  FILE_OF_OTHERS(dump, "azamat/test.particles")
  const FramePack gel = formats::OpenFile(data).Pack();
  EXPECT_EQ(gel.Pack.Size(), 514u);
  EXPECT_NEAR(Radii(gel).first, 0.00908352, 1e-9);
  EXPECT_NEAR(Radii(gel).second, 0.0122803, 1e-7);
  auto two = formats::OpenFile(mercury);
  EXPECT_EQ(ruc::FrameTimes(two.Frames), (std::vector<double>{ 0, 0.00601 }));
  EXPECT_EQ(two.Pack(1).Pack.Radius, std::vector<double>(2, 0.5));
  const FramePack bed = formats::OpenFile(dump).Pack();
  EXPECT_EQ(bed.Pack.Size(), 22410u);
  EXPECT_FALSE(bed.BoxIsWindow);
}

TEST(FilesOfOthers, Tilted)
{
  FILE_OF_OTHERS(plain, "../formats/others/lammps_triclinic.dump")
  FILE_OF_OTHERS(scaled, "../formats/others/lammps_triclinic_scaled.dump")
  FILE_OF_OTHERS(data, "../formats/others/lammps_triclinic.data")
  ruc::PackSettings periodic;
  periodic.Periodic = { true, true, true };
  std::vector<FramePack> packs;
  for (const std::string& file : { plain, scaled, data })
  {
    packs.push_back(formats::OpenFile(file).Pack(0, periodic));
    const FramePack& pack = packs.back();
    EXPECT_EQ(pack.Pack.Size(), 200u);
    EXPECT_EQ(Radii(pack), std::make_pair(0.5, 0.5));
    EXPECT_NEAR(Fraction(pack), 0.145444, 1e-6);
    EXPECT_EQ(pack.Box->Periodic, (std::array<bool, 3>{ true, false, false }));
    EXPECT_TRUE(pack.BoxIsWindow);
    for (std::size_t i = 0; i < 200; ++i)
    {
      ASSERT_TRUE(pack.Box->Contains(pack.Pack.Centre(i)));
      for (int q = 0; q < 3; ++q)
      {
        ASSERT_NEAR(pack.Pack.Centre(i)[q], packs[0].Pack.Centre(i)[q], 1e-7);
      }
    }
  }
}

TEST(FilesOfOthers, Lbpm)
{
  const std::map<std::string, double> files = { { "lbpm/Sph125_pack.out", 1 - 0.369 },
    { "lbpm/Sph1896_pack.out", 1 - 0.36 } };
  for (const auto& [name, fraction] : files)
  {
    FILE_OF_OTHERS(file, name)
    const FramePack pack = formats::OpenFile(file).Pack();
    EXPECT_NEAR(Fraction(pack), fraction, 6e-4) << name; // three digits of the porosity
    EXPECT_TRUE(pack.BoxIsWindow);
  }
  FILE_OF_OTHERS(other, "pmmoto/10pack.out")
  FILE_OF_OTHERS(mixed, "pmmoto/sphere_pack.in")
  EXPECT_TRUE(formats::OpenFile(other).Pack().BoxIsWindow);
  EXPECT_NEAR(formats::OpenFile(mixed).Pack().Box->Size[0], 8.871134, 1e-9);
}
