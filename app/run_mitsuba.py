"""Renders scene.xml once with Mitsuba 3: run_mitsuba.py VARIANT SCENE.xml SPP SEED THREADS OUT.exr

Without arguments after VARIANT: prints Mitsuba's version, if that variant is at hand.
"""
import sys

import drjit
import mitsuba

variant, *job = sys.argv[1:]
mitsuba.set_variant(variant)
if not job:
    print("Mitsuba", mitsuba.__version__)
    sys.exit()
scene, spp, seed, threads, output = job
drjit.set_thread_count(int(threads))
mitsuba.set_log_level(mitsuba.LogLevel.Error)
image = mitsuba.render(mitsuba.load_file(scene), spp=int(spp), seed=int(seed))
mitsuba.util.write_bitmap(output, mitsuba.Bitmap(image, mitsuba.Bitmap.PixelFormat.RGB), write_async=False)
