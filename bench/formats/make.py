"""Makes what the tests of the motion readers hold theirs against, with ObsPy and gmprocess.

    python bench/formats/make.py written     tests/data/motions: El Centro 1940, its first 240 samples in millionths of g, written by
                                             ObsPy in every encoding that Dolmen reads
    python bench/formats/make.py expected    tests/data/peers.csv: what ObsPy and gmprocess read from the files of data/cache/formats
                                             (scripts/data --formats): channel, samples, rate, first, last, sum and peak

ObsPy 1.5.1, gmprocess 2.8.0 (requirements.txt).
"""

import csv
import re
import sys
import warnings
from pathlib import Path

import numpy as np
import obspy

warnings.filterwarnings("ignore")
ROOT = Path(__file__).resolve().parents[2]
TESTS = ROOT / "crates/dolmen-records/tests/data"
CACHE = ROOT / "data/cache/formats"
SAMPLES = 240


def written():
    folder = TESTS / "motions"
    folder.mkdir(parents=True, exist_ok=True)
    with open(ROOT / "data/el_centro_1940_ns/el_centro_1940_ns.csv") as file:
        g = [float(row["acceleration_g"]) for row in csv.DictReader(file)][:SAMPLES]
    counts = np.round(np.array(g) * 1e6).astype(np.int32)

    def trace(data, channel="HNN"):
        header = {"network": "US", "station": "ELC", "channel": channel, "sampling_rate": 50.0,
                  "starttime": obspy.UTCDateTime(1940, 5, 19, 4, 36, 41, 250000)}
        return obspy.Trace(np.ascontiguousarray(data), header)

    for encoding, dtype in [("STEIM1", np.int32), ("STEIM2", np.int32), ("INT32", np.int32), ("FLOAT32", np.float32), ("FLOAT64", np.float64)]:
        for order, name in [(">", "big"), ("<", "little")]:
            path = folder / f"{encoding.lower()}_{name}.mseed"
            trace(counts.astype(dtype)).write(str(path), format="MSEED", encoding=encoding, byteorder=order, reclen=512)
    thousandths = np.round(np.array(g) * 1e3).astype(np.int16)
    trace(thousandths).write(str(folder / "int16_big.mseed"), format="MSEED", encoding="INT16", byteorder=">", reclen=256)
    both = obspy.Stream([trace(counts), trace(-counts // 2, "HNE")])
    both.write(str(folder / "two_channels.mseed"), format="MSEED", encoding="STEIM2", reclen=512)
    north = trace(counts.astype(np.float32))
    north.stats.sac = {"cmpaz": 0.0, "cmpinc": 90.0, "kcmpnm": "HNN"}
    north.write(str(folder / "little.sac"), format="SAC", byteorder="<")
    north.write(str(folder / "big.sac"), format="SAC", byteorder=">")
    north.write(str(folder / "text.sac"), format="SACXY")
    cosmos(folder / "one_channel.v1c", trace(counts.astype(np.float64)))
    print(counts.sum(), counts[0], counts[-1], abs(counts).max())


def cosmos(path, tr):
    """COSMOS V1 by the writer of gmprocess, which takes the mean off and prints cm/s² a hundred times too large, but not the peak."""
    import tempfile

    from gmprocess.core.scalar_event import ScalarEvent
    from gmprocess.core.stationstream import StationStream
    from gmprocess.core.stationtrace import StationTrace
    from gmprocess.io.asdf.stream_workspace import StreamWorkspace
    from gmprocess.io.cosmos.cosmos_writer import CosmosWriter, Volume
    from gmprocess.utils.config import get_config

    coordinates = {"latitude": 32.794, "longitude": -115.549, "elevation": 0.0}
    standard = {
        "units": "cm/s^2", "units_type": "acc", "process_level": "uncorrected physical units", "instrument": "", "comments": "",
        "structure_type": "", "corner_frequency": 0.0, "sensor_serial_number": "", "source": "USGS", "source_format": "csv", "source_file": "",
        "station_name": "El Centro", "instrument_period": 0.1, "instrument_damping": 0.6, "process_time": "",
        "horizontal_orientation": 180.0, "vertical_orientation": 0.0, "structure_cosmos_code": 999, "instrument_sensitivity": 1.0,
        "volts_to_counts": 1.0,
    }
    whole = StationTrace(data=tr.data, header={**tr.stats, "coordinates": coordinates, "standard": standard,
                                               "format_specific": {"stage_1_sensitivity": 1.0, "data_logger_sensitivity": 1.0}})
    whole.set_parameter("corner_frequencies", {"type": "constant", "highpass": 0.1, "lowpass": 20.0})
    event = ScalarEvent.from_params("ci1", "1940-05-19T04:36:41", 32.733, -115.5, 6.0, 6.9)
    with tempfile.TemporaryDirectory() as scratch:
        book = Path(scratch) / "book.h5"
        workspace = StreamWorkspace(book)
        workspace.add_config(get_config())
        workspace.add_event(event)
        workspace.add_gmprocess_version("2.8.0.dev0")
        workspace.add_streams(event, [StationStream([whole])], label="unprocessed", gmprocess_version="2.8.0.dev0")
        workspace.close()
        CosmosWriter(Path(scratch), book, label="unprocessed", volume=Volume.CONVERTED).write()
        [file] = Path(scratch).glob("*.V1c")
        text = file.read_text()
        path.write_text(re.sub(r"(<AUTH>) .*", lambda found: found[1].ljust(len(found[0])), text))  # when it was written


def peers():
    """What each file holds: (id, samples, rate, numbers)."""
    for path in sorted(CACHE.iterdir()):
        if path.suffix in (".v1", ".RAW"):
            from gmprocess.io.dmg.core import read_dmg

            for stream in read_dmg(str(path)):
                for tr in stream:
                    yield path.name, tr.stats.standard.horizontal_orientation, tr  # cm/s²
        else:
            for tr in obspy.read(str(path)):
                yield path.name, "", tr


def expected():
    with open(TESTS / "peers.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["file", "channel", "azimuth_deg", "samples", "rate_hz", "first", "last", "sum", "peak"])
        for name, azimuth, tr in peers():
            data = tr.data.astype(np.float64)
            row = [name, tr.id, azimuth, len(data), repr(float(tr.stats.sampling_rate))]
            out.writerow(row + [repr(float(v)) for v in (data[0], data[-1], data.sum(), abs(data).max())])


if __name__ == "__main__":
    {"written": written, "expected": expected}[sys.argv[1]]()
