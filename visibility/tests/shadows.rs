//! Every option of `sightlines shadows` on a small scene: what it changes, in counts, and what is said of what makes no
//! sense.

use std::path::PathBuf;
use std::process::{Command, Output};

use sightlines_visibility::sets;
use sightlines_visibility::setup::{Settings, Setup};
use sightlines_visibility::shadows::Sets;

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Folder(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn put(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }

    fn run(&self, line: &str) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sightlines"));
        command.arg("shadows").args(line.split_whitespace()).args(["--backend", "cpu"]);
        command.current_dir(self.0.path()).output().unwrap()
    }

    /// Bakes a cube over 16 × 16 texels with 64 samples, unless told otherwise; the answer is its sets and the mean
    /// share.
    fn bake(&self, options: &str) -> (Sets, String) {
        let picture = if options.contains(" -o ") { "" } else { "-o a.png" };
        let output = self.run(&format!("{options} --sets a.sets {picture} --exr a.exr"));
        assert!(output.status.success(), "{options}: {}", String::from_utf8_lossy(&output.stderr));
        let report = String::from_utf8(output.stdout).unwrap();
        let visible = report.lines().find_map(|line| line.strip_prefix("visible ")).unwrap_or_default();
        (sets::read(&self.path("a.sets")).unwrap(), visible.trim().split(' ').next().unwrap_or_default().to_owned())
    }

    /// Channels of the PNG, and its pixels' bytes.
    fn png(&self, name: &str) -> (usize, Vec<u8>) {
        let file = std::io::BufReader::new(std::fs::File::open(self.path(name)).unwrap());
        let mut reader = png::Decoder::new(file).read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut bytes).unwrap();
        (frame.color_type.samples(), bytes)
    }

    fn refuses(&self, line: &str) -> String {
        let output = self.run(line);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{line}: {message}");
        message
    }
}

const BOX: &str = "--scene box --resolution 16 --samples 64";

fn hidden(sets: &Sets) -> u32 {
    sets.masks.iter().map(|word| word.count_ones()).sum()
}

#[test]
fn patterns_give_each_their_sets() {
    let folder = Folder::new();
    folder.put("points.txt", "# four\n0.1 0.1\n0.9 0.1\n0.1 0.9\n0.9 0.9\n");
    let mut counts = Vec::new();
    for option in ["grid", "jittered", "halton", "blue-noise"] {
        let (sets, _) = folder.bake(&format!("{BOX} --pattern {option}"));
        assert_eq!((sets.samples, sets.words, sets.bits), (64, 2, 32));
        counts.push(hidden(&sets));
    }
    assert_eq!(counts, [3600, 3677, 3675, 3659]);
    let (sets, _) = folder.bake("--scene box --resolution 16 --samples 4 --pattern points.txt");
    assert_eq!((sets.samples, hidden(&sets)), (4, 196));
    let (other, _) = folder.bake(&format!("{BOX} --pattern jittered --seed 2"));
    assert_ne!(hidden(&other), counts[1], "the seed does not show");
}

#[test]
fn words_of_31_bits_and_more_than_one_pass() {
    let folder = Folder::new();
    let (full, mean) = folder.bake("--scene box --resolution 8 --samples 1984 --pattern halton");
    let (short, same) = folder.bake("--scene box --resolution 8 --samples 1984 --pattern halton --word-bits 31");
    assert_eq!((full.words, short.words, short.bits), (62, 64, 31));
    assert_eq!((hidden(&full), &mean), (hidden(&short), &same));
    for texel in 0..64 {
        assert!((0..1984).all(|s| full.is_hidden(texel, s) == short.is_hidden(texel, s)));
    }
}

#[test]
fn decorrelation_changes_sets_and_keeps_the_mean() {
    let folder = Folder::new();
    let (plain, mean) = folder.bake(BOX);
    let (shifted, noisy) = folder.bake(&format!("{BOX} --decorrelate"));
    assert_ne!(plain.masks, shifted.masks);
    let [mean, noisy] = [mean, noisy].map(|mean| mean.parse::<f64>().unwrap());
    assert!((mean - noisy).abs() < 0.01, "{mean} and {noisy}");
}

const LIGHT: &str = "[[light]]\ncorner = [-0.6, 4.0, -0.6]\nu = [1.2, 0.0, 0.0]\nv = [0.0, 0.0, 1.2]\n";

#[test]
fn lights_of_several_colours_and_forms() {
    let folder = Folder::new();
    let scene =
        |more: &str| format!("generator = \"box\"\nresolution = 16\nsamples = 60\npattern = \"halton\"\n{LIGHT}{more}");
    folder.put("white.toml", &scene(""));
    folder.put("tubes.toml", &scene("tubes = { count = 2, width = 0.5, colours = [[1, 0, 0], [0, 0, 1]] }\n"));
    folder
        .put("polygon.toml", &scene("polygons = [{ corners = [[0, 0], [1, 0], [0, 1]], colour = [0.0, 1.0, 0.0] }]\n"));
    let (_, white) = folder.bake("--scene-file white.toml");
    assert_eq!(folder.png("a.png").0, 1);
    let (sets, tubes) = folder.bake("--scene-file tubes.toml");
    assert_eq!((sets.samples, white == tubes), (60, false));
    let (channels, bytes) = folder.png("a.png");
    let sum = |i: usize| bytes.iter().skip(i).step_by(channels).map(|byte| u32::from(*byte)).sum::<u32>();
    // Each half of the light has one of the colours, and none has green.
    assert_eq!((channels, sum(1)), (3, 0));
    assert!(sum(0).abs_diff(sum(2)) < sum(0) / 10, "{} and {}", sum(0), sum(2));
    folder.bake("--scene-file polygon.toml --result irradiance");
    let (_, bytes) = folder.png("a.png");
    assert_eq!(bytes.iter().max(), Some(&255), "the brightest is white");
    assert!(bytes.chunks(3).all(|pixel| pixel[0] == 0 && pixel[2] == 0));
    // An image that is a picture of the light: here that of the tubes' own shadow.
    folder.put("image.toml", &scene("image = \"a.png\"\n"));
    let (sets, _) = folder.bake("--scene-file image.toml -o b.png --colours 3");
    assert_eq!(sets.samples, 60);
}

#[test]
fn readings_bound_the_share_and_a_sample_sees_its_receivers() {
    let folder = Folder::new();
    let share = |option: &str| folder.bake(&format!("{BOX} {option}")).1.parse::<f64>().unwrap();
    let [low, mid, high] = ["aggressive", "centre", "conservative"].map(|name| share(&format!("--reading {name}")));
    assert!(low < mid && mid < high, "{low}, {mid}, {high}");
    let (sets, _) = folder.bake(&format!("{BOX} --seen-from 9"));
    let (_, bytes) = folder.png("a.png");
    assert!(bytes.iter().enumerate().all(|(texel, byte)| (*byte == 0) == sets.is_hidden(texel, 9)));
    assert!(bytes.contains(&0) && bytes.contains(&255));
}

#[test]
fn heights_lightmaps_and_motion() {
    let folder = Folder::new();
    let (flat, _) = folder.bake(BOX);
    let (bumps, _) = folder.bake(&format!("{BOX} --heights bumps --height-scale 0.4"));
    assert_ne!(flat.masks, bumps.masks);
    // A picture of heights: that of a shadow.
    folder.bake(&format!("{BOX} --heights a.png --height-scale 0.2 -o b.png"));
    folder.put(
        "side.toml",
        "generator = \"ground\"\nlightmap = true\nresolution = 16\nsamples = 32\n[[light]]\n\
        corner = [9.0, 2.0, -3.0]\nu = [0.0, 0.0, 6.0]\nv = [-0.4, 1.0, 0.0]\n",
    );
    let (ground, _) = folder.bake("--scene-file side.toml");
    let dark = (0..256).filter(|t| (0..32).all(|s| ground.is_hidden(*t, s))).count();
    let lit = (0..256).filter(|t| (0..32).all(|s| !ground.is_hidden(*t, s))).count();
    assert_eq!((dark, lit), (79, 87));
    // In a view from straight above, without perspective, pixels are texels of the plane, rounded to the grid.
    let side = 4.0 * (0.75f64).sqrt();
    let (above, _) = folder.bake(&format!("{BOX} --camera 0,9,0/0,0,0/height={side}"));
    let differ: u32 = flat.masks.iter().zip(&above.masks).map(|(a, b)| (a ^ b).count_ones()).sum();
    assert!(differ < hidden(&flat) / 10, "{differ} of {}", hidden(&flat));
    let (moved, _) = folder.bake(&format!("{BOX} --motion 0.5,0,-0.25 --frames 3"));
    assert!(hidden(&moved) > hidden(&flat), "a union is not smaller");
}

/// The manual names every scene file and picture beside it, and every such file loads.
#[test]
fn the_manuals_scenes_load() {
    let docs = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let manual = std::fs::read_to_string(docs.join("shadows.md")).unwrap();
    let mut scenes = 0;
    for entry in std::fs::read_dir(docs.join("shadows")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy();
        assert!(manual.contains(&format!("shadows/{name}")), "the manual does not show {name}");
        if path.extension().is_some_and(|extension| extension == "toml") {
            Setup::load(&path, &Settings::default()).unwrap();
            scenes += 1;
        }
    }
    assert_eq!(scenes, 8);
}

#[test]
fn what_makes_no_sense_is_named() {
    let folder = Folder::new();
    folder.put("bad.txt", "0.5 0.5\n0.5 1.5\n");
    folder.put("bare.obj", "v 0 1 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\n");
    folder.put("two.obj", "v 0 1 0\nv 1 1 0\nv 0 1 1\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 2/2\n");
    let light = |more: &str| format!("generator = \"box\"\n{LIGHT}{more}");
    folder.put("forms.toml", &light("image = \"a.png\"\ntubes = { count = 2, width = 0.5 }\n"));
    folder.put("black.toml", &light("colour = [0.0, 0.0, 0.0]\n"));
    folder.put("part.toml", "generator = \"box\"\n[motion]\noffset = [1, 0, 0]\nframes = 2\npart = \"lid\"\n");
    folder.put("outside.toml", &light("polygons = [{ corners = [[0, 0], [2, 0], [0, 1]] }]\n"));
    for (line, expected) in [
        ("--scene box --pattern spiral", "spiral: cannot be read"),
        ("--scene box --pattern bad.txt", "bad.txt:2: `0.5 1.5` is no point"),
        ("--scene box --samples 37", "37 samples make a grid of 37 by 1"),
        ("--scene box --word-bits 30", "word bits: 30 samples a word"),
        ("--scene box --colours 0", "colours: 0 colours are out of range"),
        ("--scene box --heights none.png", "none.png: cannot be read"),
        ("--scene box --heights bumps --height-scale nan", "height scale: NaN is out of range"),
        ("--scene box --lightmap", "part `box`, triangle 1: it has no texture coordinates"),
        ("--scene box --camera 1,2,3", "--camera: `1,2,3` is no camera"),
        ("--scene box --camera 0,4,0/0,9,0", "does not see the receiver"),
        ("--scene box --camera 0,4,4/0,0,0 --heights bumps", "three kinds of receivers"),
        ("bare.obj --lightmap", "triangle 1: it has no texture coordinates"),
        ("two.obj --lightmap --resolution 8", "triangle 2: it covers texel"),
        ("--scene box --motion 1,0", "write three numbers"),
        ("--scene box --motion 1,0,0 --frames 1", "motion: 1 frames"),
        ("--scene box --motion 1,0,0", "--frames"),
        ("--scene box --samples 64 --seen-from 64", "there is no sample 64"),
        ("--scene box --reading aggressive --result irradiance", "--reading: irradiance has no readings"),
        ("--scene-file forms.toml", "forms.toml:2: light: it has several forms"),
        ("--scene-file black.toml", "black.toml:2: light: the colour [0.0, 0.0, 0.0] does not shine"),
        ("--scene-file part.toml", "part.toml:2: motion: there is no part `lid`"),
        ("--scene-file outside.toml", "outside.toml:2: light: a corner at [2.0, 0.0]"),
    ] {
        let message = folder.refuses(&format!("{line} -o never.png"));
        assert!(message.contains(expected), "{line}: {message}");
        assert!(!folder.path("never.png").exists(), "{line}");
    }
}
