# SPDX-License-Identifier: BSD-3-Clause
"""Opens both time series of a run with both XDMF readers of VTK, as ParaView does.   series_test.py SOLVER"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
    from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
    from vtkmodules.vtkIOXdmf3 import vtkXdmf3Reader
except ImportError as missing:
    print(f"skipped: {missing}. The readers come with the Debian package python3-paraview.")
    sys.exit(77)

RUN = """
[fluid]
lambda = 5
[channel]
length_x_um = 16
length_y_um = 12
length_z_um = 10
[flow]
mean_velocity_mm_per_s = 1.5
initial = developed
[cell]
subdivisions = 3
position_x_um = 15
rotation_angle_deg = 90
[cell.2]
shape = sphere
radius_um = 4
position_x_um = 7
subdivisions = 3
[numerics]
node_spacing_um = 2/3
time_step_us = 1.25
[time]
end_time_s = 5e-5
[output]
snapshot_interval_s = 2.5e-5
cell_snapshot_interval_s = 1.25e-5
snapshot_stride = 2
"""
READERS = (vtkXdmfReader, vtkXdmf3Reader)
RUN_DIRECTORY = tempfile.TemporaryDirectory()


def open_series(reader_class, name):
    """The reader and the times it offers."""
    reader = reader_class()
    reader.SetFileName(os.path.join(RUN_DIRECTORY.name, "snapshots", name))
    reader.UpdateInformation()
    times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    return reader, times


def grid_at(reader, time):
    reader.UpdateTimeStep(time)
    grid = reader.GetOutputDataObject(0)
    while grid.IsA("vtkMultiBlockDataSet"):
        grid = grid.GetBlock(0)
    return grid


def array(grid, name):
    return vtk_to_numpy(grid.GetPointData().GetArray(name))


class Series(unittest.TestCase):
    def test_fields(self):
        for reader_class in READERS:
            reader, times = open_series(reader_class, "fields.xdmf")
            self.assertEqual([round(t / 1.25e-6) for t in times], [0, 20, 40])
            grid = grid_at(reader, times[-1])
            self.assertEqual(grid.GetDimensions(), (12, 9, 8))
            for value in grid.GetSpacing():
                self.assertAlmostEqual(value, 4 / 3)
            for value in grid.GetOrigin():
                self.assertAlmostEqual(value, 1 / 3)
            u = array(grid, "velocity_mm_per_s").reshape(8, 9, 12, 3)
            self.assertGreater(u[4, 4, :, 0].min(), 1.5)  # axes are not mixed up: fast along the axis, slow at the walls
            self.assertLess(u[0, :, :, 0].max(), 1.5)
            inside = array(grid, "inside")
            self.assertEqual(set(inside), {0, 1})
            self.assertEqual(array(grid, "pressure_Pa").shape, (864,))
            self.assertGreater(abs(array(grid, "membrane_force_pN_per_um3")).max(), 0.1)

    def test_cells(self):
        for reader_class in READERS:
            reader, times = open_series(reader_class, "cells.xdmf")
            self.assertEqual([round(t / 1.25e-6) for t in times], [0, 10, 20, 30, 40])
            last = grid_at(reader, times[-1])
            self.assertEqual((last.GetNumberOfPoints(), last.GetNumberOfCells()), (2 * 642, 2 * 1280))
            for name in ("tension_uN_per_m", "area_strain", "mean_curvature_per_um"):
                self.assertEqual(array(last, name).shape, (1284,))
            self.assertEqual(array(last, "force_pN").shape, (1284, 3))
            self.assertEqual(sorted(set(vtk_to_numpy(last.GetCellData().GetArray("cell")))), [0, 1])
            self.assertGreater(last.GetBounds()[1], 16)  # beyond the seam, and whole:
            points = vtk_to_numpy(last.GetPoints().GetData())
            for t in range(0, last.GetNumberOfCells(), 7):
                ids = last.GetCell(t).GetPointIds()
                corners = points[[ids.GetId(c) for c in range(3)]]
                self.assertLess((corners.max(axis=0) - corners.min(axis=0)).max(), 2)
            first = grid_at(reader, times[0])
            sphere = array(first, "mean_curvature_per_um")[642:]
            self.assertLess(abs(sphere * 4 - 1).max(), 0.05)

    def test_both_readers_see_the_same(self):
        for series, name in (("fields.xdmf", "velocity_mm_per_s"), ("cells.xdmf", "force_pN")):
            seen = []
            for reader_class in READERS:
                reader, times = open_series(reader_class, series)
                seen.append(array(grid_at(reader, times[1]), name).copy())
            self.assertTrue((seen[0] == seen[1]).all())

    @unittest.skipUnless(shutil.which("pvbatch") and shutil.which("Xvfb"), "pvbatch or Xvfb is not installed")
    def test_example_draws_a_picture(self):
        example = os.path.join(os.path.dirname(__file__), "../../share/examples/cell_in_flow.py")
        snapshots, picture = (os.path.join(RUN_DIRECTORY.name, name) for name in ("snapshots", "picture.png"))
        told, telling = os.pipe()  # the server chooses a display, and names it when it can be used
        # ParaView tries the display and leaves before it draws: a server that starts anew when its last client
        # leaves would refuse the second connection now and then (89 of 3000).
        words = ["Xvfb", "-displayfd", str(telling), "-screen", "0", "1280x1024x24", "-noreset"]
        server = subprocess.Popen(words, pass_fds=[telling])
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        os.close(telling)
        with os.fdopen(told) as pipe:
            display = ":" + pipe.readline().strip()
        subprocess.run(["pvbatch", example, snapshots, picture, "3.3"], check=True, timeout=100,
                       env={**os.environ, "DISPLAY": display})
        with open(picture, "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
        self.assertGreater(os.path.getsize(picture), 10000, "nothing is drawn")


if __name__ == "__main__":
    run_file = os.path.join(RUN_DIRECTORY.name, "run.ini")
    with open(run_file, "w", encoding="utf-8") as file:
        file.write(RUN)
    subprocess.run([sys.argv.pop(1), run_file, "--quiet"], check=True)
    unittest.main(verbosity=2)
