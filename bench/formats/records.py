"""Makes the files of crates/dolmen-records/tests/data/records: the same 96 numbers of two channels, each written by another program.

    python bench/formats/records.py crates/dolmen-records/tests/data/records [uff modes wav mat mat73 gcf tdms saf]

pyuff 2.5.8, scipy 1.17.1, h5py 3.16.0, ObsPy 1.5.1, npTDMS 1.13.0, hvsrpy 2.1.0 (requirements.txt).
"""
import sys, numpy as np, datetime, struct
out = sys.argv[1]
n = 96
i = np.arange(n)
# whole numbers of millionths, so that every format holds them exactly: two channels
a = np.round(30000 * np.sin(0.3 * i) + 400 * np.cos(2.1 * i)).astype(int)
b = np.round(-9000 * np.cos(0.23 * i) + 77 * np.sin(1.7 * i)).astype(int)
np.savetxt(f"{out}/samples.csv", np.c_[a, b], fmt="%d", delimiter=",", header="a,b", comments="")
START = "2024-06-05T10:00:00.250000"

def uff():
    import pyuff
    for name, binary, kind in [("text_single.uff", 0, 2), ("text_double.uff", 0, 4), ("binary_double.uff", 1, 4)]:
        f = pyuff.UFF(f"{out}/{name}")
        sets = [pyuff.prepare_151(model_name="gate", return_full_dict=True),
                pyuff.prepare_164(units_code=1, units_description="SI: Meter (newton)", temp_mode=1, length=1.0, force=1.0, temp=1.0, temp_offset=273.15, return_full_dict=True),
                pyuff.prepare_15(node_nums=[3, 7], def_cs=[0, 0], disp_cs=[0, 0], color=[1, 1], x=[0.0, 1.5], y=[0.25, 0.0], z=[3.0, 6.0], return_full_dict=True)]
        for node, direction, samples in [(3, 1, a), (7, -2, b)]:
            sets.append(dict(type=58, binary=binary, func_type=1, rsp_node=node, rsp_dir=direction, ref_node=1, ref_dir=1, data=samples * 1e-3, x=i * 0.005,
                id1="gate", rsp_ent_name="gate", ref_ent_name="gate", abscissa_spacing=1, abscissa_min=0.0, abscissa_inc=0.005, ord_data_type=kind,
                abscissa_spec_data_type=17, abscissa_axis_units_lab="s", ordinate_spec_data_type=12, ordinate_axis_lab="acceleration",
                ordinate_axis_units_lab="mm/s^2", orddenom_spec_data_type=0, z_axis_spec_data_type=0))
        f._write_set(sets[0], "overwrite")
        for one in sets[1:]:
            f._write_set(one, "add", force_double=False)
    # a big-endian single precision file, which pyuff reads and does not write
    text = open(f"{out}/binary_double.uff", "rb").read()
    n8, n4 = b"%12i" % (8 * n), b"%12i" % (4 * n)
    text = text.replace(b"b     1     2          11" + n8, b"b     2     2          11" + n4).replace(b"         4%10i" % n, b"         2%10i" % n)
    for x in (a, b):
        text = text.replace((x * 1e-3).astype("<f8").tobytes(), (x * 1e-3).astype(">f4").tobytes())
    open(f"{out}/binary_single_big.uff", "wb").write(text)
    for name in ["text_single.uff", "text_double.uff", "binary_double.uff", "binary_single_big.uff"]:
        f = pyuff.UFF(f"{out}/{name}")
        read = [s for s in f.read_sets() if s["type"] == 58]
        assert len(read) == 2
        for s, x in zip(read, (a, b)):
            assert np.abs(s["data"] - x * 1e-3).max() < 2e-4, (name, np.abs(s["data"] - x * 1e-3).max())

def modes():
    import pyuff
    nodes = [11, 12, 13]
    sets = [pyuff.prepare_164(units_code=1, units_description="SI", temp_mode=1, length=1.0, force=1.0, temp=1.0, temp_offset=0.0),
            pyuff.prepare_15(node_nums=nodes, def_cs=[0] * 3, disp_cs=[0] * 3, color=[1] * 3, x=[0.0] * 3, y=[0.0] * 3, z=[3.0, 6.0, 9.0])]
    same = dict(model_type=1, id1="m", id2="m", id3="NONE", id4="NONE", id5="NONE", data_ch=2, spec_data_type=8, load_case=0, node_nums=nodes)
    real = [(2.125, 0.0125, [0.35, 0.7, 1.0], [0, 0, 0]), (2.75, 0.02, [0.01, 0, 0.02], [0.4, 0.75, 1.0]), (6.5, 0.03, [-1.0, -0.5, 0.8], [0, 0, 0])]
    for number, (hz, zeta, x, y) in enumerate(real, 1):
        sets.append(pyuff.prepare_55(**same, analysis_type=2, mode_n=number, modal_m=1.0, freq=hz, modal_damp_vis=zeta, modal_damp_his=0.0,
            r1=np.array(x, float), r2=np.array(y, float), r3=np.zeros(3)))
    zeta, omega = 0.015, 2 * np.pi * 9.25
    sets.append(pyuff.prepare_55(**same, analysis_type=3, mode_n=4, eig=complex(-zeta * omega, omega * np.sqrt(1 - zeta**2)), modal_a=1 + 0j, modal_b=1 + 0j,
        r1=np.array([1, -0.9, 0.5]) * np.exp(0.3j), r2=np.zeros(3) + 0j, r3=np.zeros(3) + 0j))
    f = pyuff.UFF(f"{out}/../modes/modes_pyuff.uff")
    for at, one in enumerate(sets):
        f._write_set(one, "add" if at else "overwrite")

def wav():
    from scipy.io import wavfile
    both = np.c_[a, b]
    wavfile.write(f"{out}/int16.wav", 200, both.astype(np.int16))
    wavfile.write(f"{out}/int32.wav", 200, (both * 65536).astype(np.int32))
    wavfile.write(f"{out}/float32.wav", 200, (both / 32768).astype(np.float32))
    wavfile.write(f"{out}/float64.wav", 200, both / 32768)
    import wave
    w = wave.open(f"{out}/int24.wav", "wb")  # Python's own
    w.setnchannels(2); w.setsampwidth(3); w.setframerate(200)
    w.writeframes(b"".join(struct.pack("<i", int(x) * 256)[:3] for x in both.ravel())); w.close()

def mat():
    from scipy.io import savemat
    values = {"acc": np.c_[a, b] * 1e-3, "fs": 200.0, "note": "gate", "other": np.zeros((3, 3))}
    savemat(f"{out}/plain.mat", values)
    savemat(f"{out}/compressed.mat", values, do_compression=True)
    savemat(f"{out}/vectors.mat", {"t": i * 0.005, "roof": a.astype(np.int16), "floor": b.astype(np.int32)}, do_compression=True)
    savemat(f"{out}/wide.mat", {"data": (np.c_[a, b] * 1e-3).T.astype(np.float32)})

def mat73():
    import h5py
    def write(name, values, libver, **how):
        with h5py.File(f"{out}/{name}", "w", userblock_size=512, libver=libver) as f:
            for key, value in values.items():
                if isinstance(value, str):  # as MATLAB has texts: numbers of 16 bits
                    set_ = f.create_dataset(key, data=np.array([[ord(c)] for c in value], dtype=np.uint16))
                    set_.attrs["MATLAB_class"] = np.bytes_("char")
                    set_.attrs["MATLAB_int_decode"] = np.int32(2)
                    continue
                value = np.atleast_2d(value)
                set_ = f.create_dataset(key, data=value.T, **(how if value.size > 9 else {}))
                kind = {"float64": "double", "float32": "single"}.get(str(value.dtype), str(value.dtype))
                set_.attrs["MATLAB_class"] = np.bytes_(kind)
            f.create_group("gate").attrs["MATLAB_class"] = np.bytes_("struct")
            f.create_dataset("none", data=np.array([0, 0], dtype=np.uint64)).attrs["MATLAB_empty"] = np.uint8(1)
            f["none"].attrs["MATLAB_class"] = np.bytes_("double")
            f.create_dataset("wave", data=np.ones((2, 1), dtype=complex)).attrs["MATLAB_class"] = np.bytes_("double")
        head = b"MATLAB 7.3 MAT-file, Platform: GLNXA64, Created on: Wed Jun  5 10:00:00 2024 HDF5 schema 1.00 ."
        with open(f"{out}/{name}", "r+b") as f:
            f.write(head.ljust(116) + bytes(8) + b"\x00\x02IM")
    values = {"acc": np.c_[a, b] * 1e-3, "fs": 200.0, "note": "gate", "other": np.zeros((3, 3))}
    write("hdf5_plain.mat", values, "earliest")
    write("hdf5_packed.mat", values, "earliest", chunks=(2, 40), compression="gzip", shuffle=True)
    # chunks that stand over on both sides, a tree of its own for each vector; object headers and links of HDF5 1.8
    vectors = {"t": (i * 0.005)[:, None], "roof": a.astype(np.int16)[:, None], "floor": b.astype(np.int32)[:, None]}
    write("hdf5_newer.mat", vectors, ("v108", "v108"), chunks=(1, 25), compression="gzip", fletcher32=True)
    write("hdf5_big.mat", {"data": (np.c_[a, b] * 1e-3).T.astype(">f4")}, "earliest", chunks=(10, 2))
    write("hdf5_other.mat", {"acc": np.c_[a, b] * 1e-3}, "latest", chunks=(2, 40), compression="lzf")

def gcf():
    from obspy import Trace, Stream, UTCDateTime
    for name, x in [("int8", (a // 2000)), ("int16", a), ("int32", a * 4000)]:
        tr = Trace(x.astype(np.int32)); tr.stats.sampling_rate = 100; tr.stats.starttime = UTCDateTime("2024-06-05T10:00:00")
        tr.stats.station = "AB12"; tr.stats.channel = "HHZ"
        tr.write(f"{out}/{name}.gcf", format="GCF", stream_id="AB12Z2", system_id="ABCD")
    tr = Trace(a.astype(np.int32)); tr.stats.sampling_rate = 1000; tr.stats.starttime = UTCDateTime("2024-06-05T10:00:00.25")
    tr.write(f"{out}/fast.gcf", format="GCF", stream_id="AB12Z0", system_id="ABCD")

def tdms():
    from nptdms import TdmsWriter, ChannelObject, RootObject, GroupObject
    props = {"wf_increment": 0.005, "wf_start_time": np.datetime64(START), "wf_start_offset": 0.0, "unit_string": "mg"}
    with TdmsWriter(f"{out}/two_segments.tdms") as w:
        root, group = RootObject(properties={"title": "gate"}), GroupObject("field")
        for part in (slice(0, 60), slice(60, n)):
            w.write_segment([root, group, ChannelObject("field", "a", a[part] * 1e-3, properties=props), ChannelObject("field", "b", (b[part]).astype(np.int16), properties={**props, "unit_string": "V"})])

def saf():
    # no program at hand writes SAF: written here, and read back by hvsrpy
    lines = ["SESAME ASCII data format (saf) v. 1   (this line must not be modified)", "# a comment", "STA_CODE = GATE", "START_TIME = 2024 6 5 10 0 0.250",
             "SAMP_FREQ = 200", f"NDAT = {n}", "CH0_ID = V", "CH1_ID = N", "CH2_ID = E", "NORTH_ROT = 0", "UNITS = count", "####" + "-" * 40]
    lines += [f"{x} {y} {x - y}" for x, y in zip(a, b)]
    open(f"{out}/three.saf", "w").write("\n".join(lines) + "\n")
    import types
    sys.modules["IPython"], sys.modules["IPython.display"] = types.ModuleType("IPython"), types.SimpleNamespace(display=None)  # only its plots need it
    import hvsrpy
    read = hvsrpy.data_wrangler.read_single(f"{out}/three.saf")
    assert (read.vt.amplitude == a).all() and (read.ns.amplitude == b).all() and (read.ew.amplitude == a - b).all() and read.vt.dt_in_seconds == 0.005

which = sys.argv[2:] or ["uff", "modes", "wav", "mat", "mat73", "gcf", "tdms", "saf"]
for name in which:
    globals()[name]()
