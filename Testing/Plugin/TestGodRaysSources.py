# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sources of scenes: their times and outputs in ParaView."""

from plugin_testing import *


class Sources(Case):
    def test_times(self):
        for name, end, steps in (
            ("GodRaysCloudLayerSource", 60.0, 0),
            ("GodRaysFireSource", 10.0, 0),
            ("GodRaysSmokeSource", 10.0, 501),
        ):
            with self.subTest(name):
                proxy = getattr(simple, name)()
                proxy.UpdatePipelineInformation()
                times = proxy.SMProxy.GetProperty("TimeRange")
                self.assertEqual([times.GetElement(i) for i in range(2)], [0.0, end])
                scene = simple.GetAnimationScene()
                scene.UpdateAnimationUsingDataTimeSteps()
                self.assertEqual((scene.StartTime, scene.EndTime), (0.0, end))
                keeper = simple.GetTimeKeeper()
                self.assertGreaterEqual(len(keeper.TimestepValues), steps)
                states = []
                for time in (0.5, 1.0):
                    proxy.UpdatePipeline(time)
                    data = simple.servermanager.Fetch(proxy)
                    states.append(vtk_to_numpy(data.GetPointData().GetScalars()).tobytes())
                self.assertNotEqual(states[0], states[1])
                simple.Delete(proxy)

    def test_the_texture_is_an_output(self):
        clouds = simple.GodRaysCloudLayerSource(TextureResolution=32)
        clouds.UpdatePipeline(1.0)
        texture = simple.servermanager.Fetch(clouds, idx=1)
        self.assertEqual(texture.GetDimensions(), (32, 32, 1))
        self.assertEqual(texture.GetPointData().GetScalars().GetNumberOfComponents(), 4)


main()
