//! `sightlines ambient` as its users meet it.

use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use super::motion::{Keys, colonnade, turning};

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Folder(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap()
    }

    fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    fn command(&self, line: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sightlines"));
        command.arg("ambient").args(line.split_whitespace()).current_dir(self.0.path());
        command
    }

    /// Runs it to success; the answer is its report.
    fn report(&self, line: &str) -> String {
        let Output { status, stdout, stderr } = self.command(line).output().unwrap();
        assert!(status.success(), "{line}: {}", String::from_utf8_lossy(&stderr));
        String::from_utf8(stdout).unwrap()
    }

    /// Runs it to an error of the caller's; the answer is the message.
    fn refusal(&self, line: &str) -> String {
        let output = self.command(line).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{line}: {message}");
        message
    }
}

/// The rest of the report's line that begins with `key`.
fn line<'a>(report: &'a str, key: &str) -> &'a str {
    report.lines().find_map(|line| line.strip_prefix(key)).unwrap_or_else(|| panic!("no `{key}` in {report}")).trim()
}

const BOX: &str = "--scene box --backend cpu --threads 1 --level 2";

#[test]
fn a_scene_is_shaded_written_and_reported() {
    let folder = Folder::new();
    let report = folder.report(&format!("{BOX} -o a.glb -o a.ply --matrix a.occl --counts"));
    assert_eq!(folder.names(), ["a.glb", "a.occl", "a.ply"]);
    assert_eq!(line(&report, "scene "), "box: 12 triangles in 1 parts");
    assert_eq!(line(&report, "mesh "), "8 vertices at 8 positions, 0 flat triangles");
    assert_eq!(line(&report, "normals "), "computed, as the file has none");
    assert_eq!(line(&report, "lights "), "octahedron level 2: 66 directions, a bias of 1 cells");
    assert!(line(&report, "colour ").ends_with("in the mean, 1.000000 is white"), "{report}");
    assert_eq!(line(&report, "pairs "), "528 of a position and a direction");
    assert!(!report.contains("open ") && report.ends_with("wrote      a.glb\nwrote      a.ply\nwrote      a.occl\n"));
    let default = Folder::new();
    default.report(BOX);
    assert_eq!(default.names(), ["ambient.glb"]);
    assert!(default.read("ambient.glb") == folder.read("a.glb"));
}

#[test]
fn each_option_shows_in_the_result() {
    let folder = Folder::new();
    let bake = |name: &str, options: &str| {
        folder.report(&format!("--scene colonnade --backend cpu {options} -o {name}.glb"));
        folder.read(&format!("{name}.glb"))
    };
    let plain = bake("plain", "--level 2");
    let sky = bake("sky", "--level 2 --environment sky");
    let variants = [
        bake("level", "--level 3"),
        bake("healpix", "--healpix 1"),
        bake("bias", "--level 2 --bias 2000"),
        bake("weights", "--level 2 --weights equal"),
        bake("white", "--level 2 --white 0.5"),
        bake("rotate", "--level 2 --environment sky --rotate 120"),
        bake("blur", "--level 2 --environment sky --blur 40"),
        bake("up", "--level 2 --environment sky --up z"),
        sky,
    ];
    for (at, variant) in variants.iter().enumerate() {
        assert!(*variant != plain && !variants[..at].contains(variant), "variant {at}");
    }
    assert!(bake("again", "--level 2 --weights solid-angle --white 1 --rotate 0 --bias 1") == plain, "defaults");
    let ply = |gamma: &str| {
        folder.report(&format!("{BOX} -o a.ply --gamma {gamma} --white 2"));
        folder.read("a.ply")
    };
    assert!(ply("1") != ply("2.2"));
}

#[test]
fn a_run_that_was_killed_is_resumed_to_the_same_bytes() {
    let folder = Folder::new();
    let line = "--scene palms --backend cpu --level 2 --matrix a.occl";
    folder.report(&line.replace("a.occl", "whole.occl -o whole.glb"));
    let mut child = folder.command(line).stdout(Stdio::null()).spawn().unwrap();
    // Coarse levels are written first. However far it comes until it is killed, the end is the same.
    while !folder.path("a.occl").exists() && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(1));
    }
    let _ = child.kill();
    child.wait().unwrap();
    assert!(
        folder.names().iter().all(|name| name.ends_with(".occl") || name.ends_with(".glb") || name.ends_with(".part"))
    );
    let report = folder.report(&format!("{line} --resume -o a.glb"));
    assert!(line_count(&report, "resumed ") == 1, "{report}");
    assert!(folder.read("a.occl") == folder.read("whole.occl") && folder.read("a.glb") == folder.read("whole.glb"));
}

fn line_count(report: &str, key: &str) -> usize {
    report.lines().filter(|line| line.starts_with(key)).count()
}

#[test]
fn a_matrix_is_refined_and_used_again() {
    let folder = Folder::new();
    let coarse = "--scene colonnade --backend cpu --level 2 --matrix a.occl";
    folder.report(coarse);
    let report = folder.report("--scene colonnade --backend cpu --level 3 --matrix a.occl --resume");
    assert_eq!(line(&report, "resumed "), "66 of 258 directions were there");
    folder.report("--scene colonnade --backend cpu --level 3 --matrix b.occl");
    assert!(folder.read("a.occl") == folder.read("b.occl"));
    let lit = "--scene colonnade --backend cpu --level 3 --environment sky";
    let report = folder.report(&format!("{lit} --matrix a.occl --resume -o a.glb"));
    assert_eq!(line(&report, "resumed "), "258 of 258 directions were there");
    folder.report(&format!("{lit} -o b.glb"));
    assert!(folder.read("a.glb") == folder.read("b.glb"), "another light needs no other visibility");
}

#[test]
fn bad_input_is_named_and_nothing_is_written() {
    let folder = Folder::new();
    std::fs::write(folder.path("open.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    std::fs::write(folder.path("bad.hdr"), "#?RADIANCE\n\n-Y 1 +X 2\n\u{1}").unwrap();
    let bright = [b"#?RADIANCE\n\n-Y 1 +X 2\n", &[255_u8; 8][..]].concat();
    std::fs::write(folder.path("bright.hdr"), bright).unwrap();
    std::fs::write(folder.path("bad.occl"), "sightlines").unwrap();
    let before = folder.names();
    for (line, expected) in [
        ("open.obj -o a.png", "a.png: neither .glb nor .ply"),
        ("open.obj -o a.glb -o ./a.glb", "the target of another result"),
        ("open.obj -o a.glb --matrix a.glb", "the target of another result"),
        ("open.obj --picture a.jpg", "a.jpg: not .png, as pictures are"),
        ("open.obj --frames 2 --picture a.png", "open.obj: OBJ and PLY files have no animations"),
        ("open.obj --environment bright.hdr", "bright.hdr: the largest red is 1.69"),
        ("none.obj", "none.obj: cannot be read"),
        ("open.obj --environment none.hdr", "none.hdr: cannot be read"),
        ("open.obj --environment bad.hdr", "bad.hdr: scanline 1: the file ends before it does"),
        ("open.obj --matrix bad.occl --resume", "bad.occl: it is no matrix"),
        ("open.obj --gamma 0", "--gamma: 0.0 is out of range"),
        ("open.obj --white -1", "--white: -1.0 is out of range"),
        ("open.obj --blur 91", "--blur: 91.0 is out of range"),
        ("open.obj --rotate inf", "--rotate: inf is out of range"),
        ("open.obj --level 9", "9 is not in 0..=6"),
    ] {
        let message = folder.refusal(&format!("{line} --backend cpu"));
        assert!(message.contains(expected), "{line}: {message}");
    }
    assert_eq!(folder.names(), before);
    let report = folder.report("open.obj --backend cpu --level 0 -o a.ply");
    assert_eq!(line(&report, "open "), "3 edges have no triangle on one side: light passes there");
}

#[test]
fn pictures_are_taken_along_an_orbit_whole_or_lazily() {
    let folder = Folder::new();
    let line = "--scene colonnade --backend cpu --level 1 --orbit 3 --size 80x60";
    let report = folder.report(&format!("{line} --picture a.png"));
    assert!(report.ends_with("wrote      a.0.png\nwrote      a.1.png\nwrote      a.2.png\n"), "{report}");
    let report = folder.report(&format!("{line} --picture b.png --lazy --threshold 0"));
    let looks: Vec<&str> = report.lines().filter_map(|line| line.strip_prefix("picture ")).collect();
    assert_eq!(looks.len(), 3);
    assert!(looks[0].trim().starts_with("b.0.png: ") && looks[0].ends_with(" positions"), "{}", looks[0]);
    for number in 0..3 {
        let [whole, lazy] = ["a", "b"].map(|name| folder.read(&format!("{name}.{number}.png")));
        assert!(whole == lazy, "picture {number}");
    }
    assert!(folder.read("a.0.png") != folder.read("a.1.png"));
    assert_eq!(folder.names().len(), 6);
}

#[test]
fn frames_of_a_motion_keep_to_their_budget() {
    let folder = Folder::new();
    // 3,249 positions and 6,272 triangles: 18 directions cost 171,378.
    let report =
        folder.report("--motion cloth --backend cpu --level 2 --frames 3 --size 80x60 --budget 1 --picture a.png");
    let frames: Vec<&str> = report.lines().filter_map(|line| line.strip_prefix("frame ")).map(str::trim).collect();
    let level = "octahedron level 2: 66 directions, a new matrix, 214434 pairs";
    assert_eq!(frames, [0, 1, 2].map(|n| format!("a.{n}.png: {level}")));
    assert_eq!(line(&report, "matrices "), "3 for 3 frames");
    let report =
        folder.report("--motion cloth --backend cpu --level 2 --frames 1 --size 80x60 --budget 0 --picture b.png");
    assert!(report.contains("octahedron level 0: 6 directions"), "{report}");
    let pictures = [0, 1, 2].map(|n| folder.read(&format!("a.{n}.png")));
    assert!(pictures[0] != pictures[1] && pictures[1] != pictures[2]);
    assert!(folder.refusal("--scene box --frames 2 --picture c.png").contains("--frames: the scene does not move"));
    assert!(folder.refusal("--scene box --camera here --picture c.png").contains("`here` is no camera"));
}

#[test]
fn frames_say_whose_matrix_they_have() {
    let folder = Folder::new();
    let frames = |keys: &[Keys], options: &str| {
        for (name, bytes) in colonnade(keys) {
            std::fs::write(folder.path(name), bytes).unwrap();
        }
        let line = format!("a.gltf --backend cpu --level 1 --frames 4 --size 80x60 --picture a.png {options}");
        let report = folder.report(&line);
        let frames = report.lines().filter_map(|line| line.strip_prefix("frame ")).map(|line| line.trim().to_owned());
        let rest = |line: String| line.split_once("18 directions, ").unwrap().1.to_owned();
        (frames.map(rest).collect::<Vec<_>>(), report)
    };
    let (turned, report) = frames(&turning(0), "--environment sky --counts");
    let expected =
        [45, 90, 135].map(|degrees| format!("the matrix of a.0.png turned by {degrees}.00 degrees, 0 pairs"));
    assert_eq!(turned[1..], expected);
    assert!(turned[0].starts_with("a new matrix, ") && line(&report, "matrices ") == "1 for 4 frames");
    let pairs = turned[0].trim_start_matches("a new matrix, ").trim_end_matches(" pairs");
    assert_eq!(line(&report, "pairs "), format!("{pairs} of a position and a direction"));
    assert!(line(&report, "lane-ops ").contains(" a pair"));
    let pictures = [0, 1, 2, 3].map(|n| folder.read(&format!("a.{n}.png")));
    let (shifted, _) = frames(&turning(0)[1..], "--environment sky");
    assert_eq!(shifted[1..], ["as before, 0 pairs"; 3]);
    assert!(folder.read("a.0.png") == pictures[0] && folder.read("a.2.png") != pictures[2]);
    let (apart, report) = frames(&turning(1), "");
    assert!(apart.iter().all(|line| line.starts_with("a new matrix")), "{apart:?}");
    assert_eq!(line(&report, "matrices "), "4 for 4 frames");
}
