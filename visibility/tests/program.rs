//! The program `sightlines` as its users meet it: exit codes, messages, files.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use sightlines_visibility::image::Share;
use sightlines_visibility::sets;
use sightlines_visibility::shadows::Sets;

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Folder(tempfile::tempdir().unwrap())
    }

    fn put(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.path().join(name);
        std::fs::write(&path, text).unwrap();
        path
    }

    fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// Runs `sightlines` in the folder.
    fn run(&self, line: &str) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sightlines"));
        command.args(line.split_whitespace()).current_dir(self.0.path()).output().unwrap()
    }

    /// Runs it, and holds it to its exit code; the answer is what it says on standard error.
    fn fails(&self, line: &str, code: i32) -> String {
        let output = self.run(line);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(code), "{line}: {message}");
        assert!(message.contains("error: "), "{line}: {message}");
        message
    }
}

const TRIANGLE: &str = "v 0 1 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\n";

#[test]
fn bad_command_lines_and_bad_input_end_with_2() {
    let folder = Folder::new();
    folder.put("good.obj", TRIANGLE);
    folder.put("empty.obj", "");
    folder.put("cut.glb", "glTF\u{2}\0\0\0\0\0\u{1}\0\u{10}\0\0\0JSON{\"asset\":{}");
    folder.put("other.glb", "PK\u{3}\u{4}");
    folder.put("nan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 nan\nf 1 2 3\n");
    folder.put("broken.obj", "v 0 0 0\nf 1 2 3\n");
    folder.put("named.toml", "model = \"good.obj\"\n");
    folder.put("broken.toml", "generator = \"box\"\nsamples = 0\n");
    for (line, expected) in [
        ("", "Usage: sightlines"),
        ("shadows", "required"),
        ("shadows good.obj --scene palms", "cannot be used with"),
        ("shadows --scene forest", "choose one of palms, box, quads, colonnade"),
        ("shadows none.obj", "none.obj: cannot be read"),
        ("shadows empty.obj", "empty.obj: the file is empty"),
        ("shadows broken.obj", "broken.obj:2: the face uses vertex 2, and the file has 1 vertices"),
        ("shadows --scene-file broken.toml", "broken.toml:2: samples: 0 samples cannot be baked"),
        ("shadows --scene-file none.toml", "none.toml: cannot be read"),
        ("shadows good.obj --resolution 0", "resolution: 0 texels a side are out of range"),
        ("shadows good.obj --resolution 8193", "resolution: 8193 texels"),
        ("shadows good.obj --samples 70000", "samples: 70000 samples cannot be baked"),
        ("shadows good.obj --light-size -1", "light size: -1.0 is out of range"),
        ("shadows good.obj --light-size 1e300", "light size: 1e300 is out of range"),
        ("shadows good.obj --light-size 1e-9", "enlarge the light"),
        ("shadows good.obj --resolution -3", "invalid value '-3'"),
        ("shadows cut.glb", "cut.glb: it is cut off: its header says 65536 bytes, and it has 31"),
        ("shadows other.glb", "other.glb: it is no GLB"),
        ("shadows nan.obj", "vertex 3: the coordinates (0.0, 1.0, NaN) are not finite"),
        ("shadows good.obj --light-size nan", "light size: NaN is out of range"),
        ("shadows good.obj --up x", "invalid value 'x'"),
        ("shadows good.obj -o good.obj", "good.obj: the file is read, or is the target of another result"),
        (
            "shadows --scene-file named.toml -o good.obj",
            "good.obj: the file is read, or is the target of another result",
        ),
        ("shadows --scene box -o a --exr ./a", "./a: the file is read, or is the target of another result"),
        ("shadows good.obj --backend cpu --adapter llvmpipe", "--adapter: the interpreter has none"),
        ("shadows good.obj --backend wgpu --threads 2", "--threads: only the interpreter has threads"),
    ] {
        let output = folder.run(line);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{line}: {message}");
        assert!(message.contains(expected), "{line}: {message}");
    }
    let left = ["broken.obj", "broken.toml", "cut.glb", "empty.obj", "good.obj", "named.toml", "nan.obj", "other.glb"];
    assert_eq!(folder.names(), left, "nothing was written");
}

/// A triangle whose corners and whose texture are in files of their own.
const SCATTERED: &str = r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "images": [{"uri": "b%61rk.png"}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0,0,0], "max": [1,1,1]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"uri": "a.bin", "byteLength": 36}]}"#;

#[test]
fn nothing_is_written_over_what_a_scene_reads_or_names() {
    let folder = Folder::new();
    folder.put("a.gltf", SCATTERED);
    folder.put("bark.png", "no picture");
    let corners = [0.0_f32, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0];
    std::fs::write(folder.0.path().join("a.bin"), corners.map(f32::to_le_bytes).concat()).unwrap();
    folder.put("scene.toml", "model = \"a.gltf\"\n");
    folder.put("tour.txt", "0,3,5/0,1,0\n");
    let files = || folder.names().into_iter().map(|name| std::fs::read(folder.0.path().join(name)).unwrap());
    let before: Vec<Vec<u8>> = files().collect();
    for (line, target) in [
        ("shadows a.gltf -o", "a.bin"),
        ("shadows a.gltf --sets", "a.gltf"),
        ("shadows --scene-file scene.toml --exr", "./a.bin"),
        ("shadows --scene-file scene.toml -o", "bark.png"),
        ("compare a.gltf -o", "bark.png"),
        ("compare a.gltf --csv", "a.bin"),
        ("queries a.gltf --camera 0,3,5/0,1,0 --json", "a.bin"),
        ("queries a.gltf --path tour.txt --csv", "tour.txt"),
        ("ambient a.gltf --picture", "bark.png"),
        ("ambient a.gltf --matrix", "a.bin"),
    ] {
        let message = folder.fails(&format!("{line} {target} --backend cpu"), 2);
        assert!(message.contains(&format!("{target}: the file is read")), "{line} {target}: {message}");
    }
    assert!(files().eq(before));
}

#[test]
fn a_target_that_cannot_be_written_ends_with_1_before_any_work() {
    let folder = Folder::new();
    for option in ["-o", "--exr", "--sets"] {
        let message = folder.fails(&format!("shadows --scene box --backend cpu {option} none/a"), 1);
        assert!(message.contains("none/a: cannot be written") && message.contains("make its folder"), "{message}");
        let message = folder.fails(&format!("shadows --scene box --backend cpu {option} ."), 1);
        assert!(message.contains("cannot be written"), "{message}");
    }
    assert_eq!(folder.names(), [""; 0]);
}

#[cfg(unix)]
#[test]
fn a_device_that_never_ends_is_not_read() {
    let folder = Folder::new();
    folder.put("good.obj", TRIANGLE);
    std::os::unix::fs::symlink("/dev/zero", folder.0.path().join("link")).unwrap();
    for line in [
        "shadows link",
        "shadows --scene-file link",
        "queries link",
        "queries good.obj --path link",
        "ambient good.obj --environment link",
    ] {
        let message = folder.fails(line, 2);
        assert!(message.contains("link: neither a file nor a link to one"), "{line}: {message}");
    }
}

/// `sightlines … | head -1` ends the report, not the work.
#[cfg(unix)]
#[test]
fn a_report_that_nobody_reads_keeps_no_file_from_being_written() {
    let folder = Folder::new();
    folder.put("good.obj", TRIANGLE);
    for (line, file) in [
        ("shadows good.obj --resolution 8 --samples 32 -o a.png", "a.png"),
        ("queries good.obj --camera 3,3,3/0,1,0 --size 16x16 --csv a.csv", "a.csv"),
        ("ambient good.obj --level 0 -o a.ply", "a.ply"),
    ] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sightlines"));
        command.args(line.split_whitespace()).args(["--backend", "cpu"]).current_dir(folder.0.path());
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = command.stdout(writer).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), &*message), (Some(0), ""), "{line}");
        assert!(folder.0.path().join(file).exists(), "{line}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_report_that_finds_no_room_is_told() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let folder = Folder::new();
    let mut command = Command::new(env!("CARGO_BIN_EXE_sightlines"));
    command.args("shadows --scene box --backend cpu --resolution 8".split_whitespace()).current_dir(folder.0.path());
    let output = command.stdout(full).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("standard output: ") && message.contains("remedy: "), "{message}");
}

#[test]
fn one_texel_is_baked_too() {
    let folder = Folder::new();
    assert!(folder.run("shadows --scene box --backend cpu --resolution 1 -o a.png").status.success());
    assert_eq!(greys(&folder.0.path().join("a.png")), (1, vec![0]));
}

#[test]
fn a_missing_adapter_ends_with_3() {
    let folder = Folder::new();
    let message = folder.fails("shadows --scene box --backend wgpu --adapter no-such-adapter", 3);
    assert!(message.contains("no adapter matching `no-such-adapter`"), "{message}");
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn help_states_the_exit_codes_and_the_scene_file() {
    let folder = Folder::new();
    for (line, expected) in [("--help", "Exit codes:"), ("shadows --help", "[receiver]"), ("--version", "sightlines ")]
    {
        let output = folder.run(line);
        assert!(output.status.success(), "{line}");
        assert!(String::from_utf8(output.stdout).unwrap().contains(expected), "{line}");
    }
}

/// The visible share of a file of sets, counted bit by bit.
fn share(sets: &Sets) -> Share {
    let hidden = |set: &[u32]| set.iter().map(|word| word.count_ones()).sum::<u32>();
    let visible = sets.masks.chunks(sets.words as usize).map(|set| sets.samples - hidden(set)).collect();
    Share { resolution: sets.resolution, samples: sets.samples, visible }
}

/// Width and greys of a PNG of 8 bits.
fn greys(path: &Path) -> (u32, Vec<u8>) {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut data = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut data).unwrap();
    data.truncate(info.buffer_size());
    (info.width, data)
}

/// The rest of the report's line that begins with `key`.
fn line<'a>(report: &'a str, key: &str) -> &'a str {
    report.lines().find_map(|line| line.strip_prefix(key)).unwrap_or_else(|| panic!("no `{key}` in {report}")).trim()
}

#[test]
fn a_shadow_is_baked_written_and_reported() {
    let folder = Folder::new();
    let output = folder.run(
        "shadows --scene box --backend cpu --resolution 64 --samples 64 -o a.png --exr a.exr --sets a.sets --threads 1",
    );
    let (report, errors) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert_eq!((output.status.code(), errors.as_str()), (Some(0), ""), "no progress where nobody looks");
    assert_eq!(line(&report, "scene "), "box: 12 triangles in 1 part, 0 degenerate");
    assert_eq!(line(&report, "units "), "metres, y up");
    assert_eq!(line(&report, "receivers "), "64 x 64, 64 samples on 1 light");
    assert!(line(&report, "backend ").starts_with("cpu, ") && line(&report, "backend ").ends_with(", 1 thread"));
    assert!(line(&report, "grid ").ends_with(" scene units") && line(&report, "time ").ends_with(" s"));
    assert!(report.ends_with("wrote      a.png\nwrote      a.exr\nwrote      a.sets\n"), "{report}");
    assert_eq!(folder.names(), ["a.exr", "a.png", "a.sets"]);

    let (side, image) = greys(&folder.0.path().join("a.png"));
    assert_eq!(side, 64);
    assert_eq!((image[0], image[32 * 64 + 32]), (255, 0), "light in the corner, umbra in the middle");
    let baked = sets::read(&folder.0.path().join("a.sets")).unwrap();
    assert_eq!((baked.resolution, baked.samples), (64, 64));
    let share = share(&baked);
    let mean = format!("{:.6} of the light in the mean", share.mean());
    assert_eq!(line(&report, "visible "), mean);
    let expected: Vec<u8> = share.visible.iter().map(|n| ((n * 255 + 32) / 64) as u8).collect();
    assert_eq!(image, expected);
}

#[test]
fn work_is_reported_when_asked_for() {
    let folder = Folder::new();
    let report = |options: &str| {
        let line = format!("shadows --scene box --backend cpu --resolution 64 --samples 64 -o a.png {options}");
        let report = String::from_utf8(folder.run(&line).stdout).unwrap();
        report.lines().filter(|line| !line.starts_with("time ")).map(|line| format!("{line}\n")).collect::<String>()
    };
    let counted = report("--threads 1 --counts");
    assert_eq!(line(&counted, "pairs "), "2568 of a triangle and a receiver in its region, 0.6 a receiver");
    assert_eq!(line(&counted, "culled "), "2 of 12 triangles of closed surfaces");
    let whole = report("--threads 1 --counts --cull off");
    assert_eq!(line(&whole, "pairs "), "4880 of a triangle and a receiver in its region, 1.2 a receiver");
    assert_eq!(line(&whole, "culled "), "0 of 0 triangles of closed surfaces");
    assert_eq!(line(&whole, "visible "), line(&counted, "visible "));
    for (key, unit) in [("lane-ops ", " a pair"), ("work ", " barriers"), ("memory ", " bytes")] {
        let line = line(&counted, key);
        let first: u64 = line.split([' ', ',']).next().unwrap().parse().unwrap();
        assert!(first > 1000 && line.ends_with(unit), "{line}");
    }
    assert_eq!(report("--threads 1 --counts"), counted, "the same work twice");
    assert!(!report("--threads 1").contains("pairs "));
}

#[test]
fn the_shadow_of_a_cube_is_where_geometry_puts_it() {
    let folder = Folder::new();
    let output = folder.run("shadows --scene box --backend cpu --resolution 64 --samples 1024 --sets a.sets");
    assert!(output.status.success());
    assert_eq!(folder.names(), ["a.sets"], "no picture unless asked for");
    let share = share(&sets::read(&folder.0.path().join("a.sets")).unwrap());
    // R = √3/2. The receiver is 0.02 R under the cube's foot, the light 3 R above it and 0.4 R wide.
    let r = 0.75_f64.sqrt();
    let (low, high, light) = (0.02 * r, 0.02 * r + 1.0, 3.0 * r);
    // Seen from the light's edge, the cube's top throws farthest; from its other edge, its foot hides at least this.
    let outer = 0.5 + high / (light - high) * (0.5 + 0.2 * r);
    let umbra = 0.5 - low / (light - low) * (0.2 * r - 0.5).max(0.0);
    for (index, &visible) in share.visible.iter().enumerate() {
        let at = |i: usize| ((i as f64 + 0.5) / 64.0 - 0.5) * 4.0 * r;
        let farthest = at(index % 64).abs().max(at(index / 64).abs());
        if farthest > outer + 1e-3 {
            assert_eq!(visible, 1024, "texel {index}");
        }
        if farthest < umbra - 1e-3 {
            assert_eq!(visible, 0, "texel {index}");
        }
    }
}

#[test]
fn several_lights_give_one_picture_and_a_file_of_sets_each() {
    let folder = Folder::new();
    let light = |x: f64| format!("[[light]]\ncorner = [{x}, 6.0, -0.5]\nu = [1.0, 0.0, 0.0]\nv = [0.0, 0.0, 1.0]\n");
    let file = format!("model = \"a.obj\"\nresolution = 32\nsamples = 32\n{}{}", light(-3.0), light(2.0));
    folder.put("a.toml", &file);
    folder.put("a.obj", TRIANGLE);
    let output = folder.run("shadows --scene-file a.toml --backend cpu -o a.png --sets b.sets");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(folder.names(), ["a.obj", "a.png", "a.toml", "b.0.sets", "b.1.sets"]);
    let read = |name: &str| share(&sets::read(&folder.0.path().join(name)).unwrap());
    let (mut sum, other) = (read("b.0.sets"), read("b.1.sets"));
    assert_ne!(sum, other);
    sum.add(&other);
    let expected: Vec<u8> = sum.visible.iter().map(|n| ((n * 255 + 32) / 64) as u8).collect();
    assert_eq!(greys(&folder.0.path().join("a.png")).1, expected);
}

#[test]
fn threads_do_not_show_in_the_files() {
    let folder = Folder::new();
    for threads in [1, 3] {
        let line = format!("shadows --scene colonnade --backend cpu --resolution 96 --threads {threads}");
        assert!(folder.run(&format!("{line} --samples 128 -o {threads}.png --sets {threads}.sets")).status.success());
    }
    let read = |name: &str| std::fs::read(folder.0.path().join(name)).unwrap();
    assert!(read("1.png") == read("3.png") && read("1.sets") == read("3.sets"));
}

/// A limit on the size of files stands for a full disk: writing fails halfway.
#[cfg(unix)]
#[test]
fn a_full_disk_ends_with_1_and_leaves_nothing_half_written() {
    let folder = Folder::new();
    let program = env!("CARGO_BIN_EXE_sightlines");
    let line = format!("trap '' XFSZ; ulimit -f 64; exec '{program}' shadows --scene box --backend cpu --sets a.sets");
    let output = Command::new("sh").args(["-c", &line]).current_dir(folder.0.path()).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("error: a.sets: cannot be written") && message.contains("make room"), "{message}");
    assert_eq!(folder.names(), [""; 0]);
}

/// Every option of casters, receivers and maps in one small run each.
#[test]
fn casters_of_one_face_reliefs_and_maps_are_baked() {
    let folder = Folder::new();
    let visible = |options: &str| {
        let output = folder.run(&format!("shadows --backend cpu --resolution 32 --samples 64 -o a.png {options}"));
        assert!(output.status.success(), "{options}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let share = |options: &str| line(&visible(options), "visible ").split(' ').next().unwrap().parse::<f64>().unwrap();
    // One triangle, whose front looks up, to the light: its back hides nothing.
    folder.put("a.obj", "v 0 1 0\nv 0 1 1\nv 1 1 0\nf 1 2 3\n");
    let [both, front, back] = ["both", "front", "back"].map(|faces| share(&format!("a.obj --faces {faces}")));
    assert!(both < 1.0 && front == both && back == 1.0, "{both} {front} {back}");
    let heights = "--scene box --heights bumps --height-scale 0.8";
    let [flat, own] = ["", "--self"].map(|own| share(&format!("{heights} {own}")));
    assert!(own < flat, "{own} and {flat}");
    let report = visible("--scene box --camera 0,3,4/0,0,0/50 --map 64");
    assert!(line(&report, "map ").starts_with("64 x 64: "), "{report}");
    let (width, panels) = greys(&folder.0.path().join("a.png"));
    assert_eq!((width, panels.len()), (96, 96 * 32));
    for (line, expected) in [
        ("shadows --scene box --map 64", "--camera"),
        ("shadows --scene box --camera 0,3,4/0,0,0 --map 48", "power of two"),
        ("shadows --scene box --camera 0,3,4/0,0,0 --map 64 --exr a.exr", "a picture of shares"),
        ("shadows --scene box --self", "only heights"),
        ("shadows --scene box --faces left", "invalid value"),
        ("shadows --scene box --simplify most", "no target"),
    ] {
        let message = folder.fails(line, 2);
        assert!(message.contains(expected), "{line}: {message}");
    }
}

#[test]
fn methods_are_compared_in_a_table_a_picture_and_curves() {
    let folder = Folder::new();
    let output = folder.run(
        "compare --scene box --backend cpu --resolution 32 --samples 32,64 --light-size 0.4,1 -o a.png --csv a.csv --plot a.svg",
    );
    let report = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{report}{}", String::from_utf8_lossy(&output.stderr));
    for method in ["sampling ", "projections ", "tables ", "volumes ", "maps "] {
        // Three of them have a line of their own beside that in the table.
        let lines = if matches!(method, "sampling " | "tables ") { 4 } else { 8 };
        assert_eq!(report.lines().filter(|line| line.starts_with(method)).count(), lines, "{method}: {report}");
    }
    let read = |name: &str| std::fs::read_to_string(folder.0.path().join(name)).unwrap();
    let table = read("a.csv");
    assert!(table.starts_with("resolution,samples,light_side,triangles,method,pairs,lane_ops,differ,error,seconds\n"));
    assert_eq!(table.lines().count(), 1 + 4 * 5);
    let curves = read("a.svg");
    // Four methods are counted, each for two numbers of samples.
    assert_eq!(curves.matches("<polyline").count(), 8);
    assert!(curves.contains("projections, 64 samples") && curves.contains("side of the light"), "{curves}");
    assert_eq!(greys(&folder.0.path().join("a.0.png")).0, 160);
}
