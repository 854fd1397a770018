"""A file of `kyvadlo sweep` opens in xarray without a word, with coordinates, units and masks."""
import subprocess
import sys
import warnings

import numpy as np
import xarray as xr

program, plan, path = sys.argv[1:4]
subprocess.run([program, "sweep", plan, "--output", path, "--force"], check=True)
with warnings.catch_warnings():
    warnings.simplefilter("error")
    data = xr.open_dataset(path)
    data.load()
    repr(data)
    assert data["T"].dims == ("z_upper", "z_lower"), data["T"].dims
    assert data["z_upper"].attrs["units"] == "m" and data["T"].attrs["units"] == "s"
    assert data.attrs["Conventions"].startswith("CF-")
    assert data["status"].attrs["flag_meanings"].split() == ["open", "computed", "inadmissible", "refused", "failed"]
    masked = np.isnan(data["T"].values)
    assert 0 < masked.sum() < masked.size
    assert (masked == (data["status"].values != 1)).all()
    assert int(data["complete"]) == 1
    picked = float(data["T"].sel(z_upper=0.0, z_lower=-1.0, method="nearest"))
    assert abs(picked - 1.184123173143005) < 1e-15, picked
print("opened")
