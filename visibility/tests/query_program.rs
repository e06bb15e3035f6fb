//! The commands `sightlines queries` and `sightlines cull` as their users meet it: exit codes, messages, files.

use std::process::{Command, Output};

use sightlines_visibility::queries::files::read_seen;

fn run(folder: &tempfile::TempDir, line: &str) -> Output {
    sightlines(folder, &format!("queries {line}"))
}

/// Runs a command line, in which ~ is a blank within a word.
fn sightlines(folder: &tempfile::TempDir, line: &str) -> Output {
    let words = line.split_whitespace().map(|word| word.replace('~', " "));
    Command::new(env!("CARGO_BIN_EXE_sightlines")).args(words).current_dir(folder.path()).output().unwrap()
}

fn names(folder: &tempfile::TempDir) -> Vec<String> {
    let entries = std::fs::read_dir(folder.path()).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn bad_input_ends_with_2_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    put("path.txt", "# two cameras\nview\n\n1,2,3/1,2,3\n");
    put("empty.txt", "# none\n");
    for (line, expected) in [
        ("a.obj --json out.json", "--camera: scene `a.obj` has no camera"),
        ("a.obj --camera front", "there is no camera `front`: scene `a.obj` has none"),
        ("--scene crowd-3 --camera front", "scene `crowd-3` has view, light"),
        ("--scene crowd-3 --path path.txt", "path.txt:4: camera: the camera stands at [1.0, 2.0, 3.0]"),
        ("--scene crowd-3 --path empty.txt", "empty.txt: there is no camera in it"),
        ("--scene crowd-3 --path none.txt", "none.txt: cannot be read"),
        ("a.obj --camera 0,0,5/0,0,9", "nothing is in front of camera `0,0,5/0,0,9`"),
        ("a.obj --camera 0,0,5/9,0,4.9/20 --csv out.csv", "camera `0,0,5/9,0,4.9/20` sees nothing"),
        ("a.obj --camera 0,0,5/0,0,0/fish", "`fish` is no lens"),
        ("--scene crowd-3 --size 61x40 --method sat", "a picture 61 pixels wide"),
        ("--scene crowd-2000 --clusters 0 --tiles 4", "1212002 items in 2^4 by 2^4 tiles need 310272512 bins"),
        ("--scene crowd-3 --channels 2", "--channels: it belongs to the method sat"),
        ("--scene crowd-3 --method sat --clusters 3", "--clusters: it belongs to the method hib"),
        ("--scene crowd-3 --size 9x9 --json a --csv a", "a: the file is read, or is the target of another result"),
        ("a.obj --camera 0,0,5/0,0,0 --seen a.obj", "a.obj: the file is read"),
        ("--scene crowd-2001", "choose crowd-1 to crowd-2000"),
        ("none.glb", "none.glb: cannot be read"),
    ] {
        let output = run(&folder, &format!("{line} --backend cpu"));
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{line}: {message}");
        assert!(message.contains(expected), "{line}: {message}");
    }
    assert_eq!(names(&folder), ["a.obj", "empty.txt", "path.txt"]);
}

#[test]
fn a_path_gives_a_row_and_a_set_for_each_camera_and_files_say_the_same() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("path.txt"), "view # first\n0,9,0.1/0,0,0/60\n").unwrap();
    let files = "--json a.json --csv a.csv --heat a.png --seen a.seen";
    let output =
        run(&folder, &format!("--scene crowd-20 --path path.txt --size 80x60 --tiles 1 {files} --backend cpu"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(names(&folder), ["a.0.png", "a.1.png", "a.csv", "a.json", "a.seen", "path.txt"]);
    let text = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text("a.json")).unwrap();
    let csv = text("a.csv");
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "camera,instance,name,mesh,cluster,pixels,covered,tile 0 0,tile 1 0,tile 0 1,tile 1 1");
    assert_eq!(lines.len(), 1 + 2 * 21);
    let seen = read_seen(&folder.path().join("a.seen")).unwrap();
    assert_eq!(seen.len(), 2);
    for view in 0..2 {
        let items = json[view]["items"].as_array().unwrap();
        let mut visible = Vec::new();
        for (number, item) in items.iter().enumerate() {
            let pixels = item["pixels"].as_u64().unwrap();
            let tiles = item["tiles"].as_array().unwrap().iter().map(|n| n.as_u64().unwrap());
            assert_eq!(tiles.sum::<u64>(), pixels);
            let covered = item.get("covered").and_then(|covered| covered.as_u64());
            assert!(if pixels > 0 { covered >= Some(pixels) } else { covered.is_none() }, "{item}");
            let cells: Vec<&str> = lines[1 + 21 * view + number].split(',').collect();
            // A camera of words has commas, and stands in quotation marks.
            assert_eq!(cells[cells.len() - 6], pixels.to_string(), "{cells:?}");
            if pixels > 0 {
                visible.push(number);
            }
        }
        assert_eq!(seen[view], visible);
    }
    let report = String::from_utf8(output.stdout).unwrap();
    assert!(
        report.contains("scene      crowd-20: 12122 triangles") && report.contains("wrote      a.seen"),
        "{report}"
    );
    let mut bytes = std::fs::read(folder.path().join("a.seen")).unwrap();
    bytes[33] ^= 1;
    std::fs::write(folder.path().join("b.seen"), bytes).unwrap();
    let damaged = read_seen(&folder.path().join("b.seen")).unwrap_err().to_string();
    assert!(damaged.contains("b.seen: its bytes do not match their digest"), "{damaged}");
}

/// An OBJ file of so many groups of one triangle.
fn groups(count: usize, triangle: impl Fn(f64) -> String) -> String {
    let group = |i: usize| format!("g part{i}\n{}f {} {} {}\n", triangle(i as f64), 3 * i + 1, 3 * i + 2, 3 * i + 3);
    (0..count).map(group).collect()
}

#[test]
fn thousands_of_groups_in_one_place_are_counted_and_too_many_shares_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let coincident = groups(3000, |_| "v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_owned());
    std::fs::write(folder.path().join("equal.obj"), coincident).unwrap();
    let camera = "--camera 0.5,0.5,9/0.5,0.5,0/height=1 --backend cpu";
    let output = run(&folder, &format!("equal.obj --size 64x64 --seen a.seen {camera}"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(read_seen(&folder.path().join("a.seen")).unwrap(), [[0]]);
    // Each shows a row of the left side under the one before it, and all have one rectangle.
    let nested = groups(1100, |i| format!("v 0 0 {0}\nv 1 1 {0}\nv 0 {1} {0}\n", -1e-3 * i, (i + 1.0) / 1100.0));
    std::fs::write(folder.path().join("nested.obj"), nested).unwrap();
    let line = format!("nested.obj --size 8x2200 {camera}");
    let output = run(&folder, &line);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("more than 1024 of the 1100 instances lie one over the other"), "{message}");
    let output = run(&folder, &format!("{line} --no-shares"));
    let report = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success() && report.contains("seen       1100 of 1100 items"), "{report}");
}

#[test]
fn applications_cull_and_write_two_panels_and_mistakes_name_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let good = "--scene crowd-30 --size 48x32 --picture a.png --backend cpu";
    for (line, expected) in [
        ("cull volumes", "its depths without the culled are those with all"),
        ("cull volumes --method sat", "never fewer than are visible"),
        ("cull detail", "triangles drawn, and no pixel changes"),
        ("cull veils --veil ball~1*=0.25 --camera light", "of which at least 1/255 of a pixel is seen"),
        ("cull veils --veil ball~1*=0.25 --least 3 --method sat", "of which at least 3 of a pixel is seen"),
    ] {
        let output = sightlines(&folder, &format!("{line} {good}"));
        let report = String::from_utf8(output.stdout).unwrap();
        assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
        assert!(report.contains(expected), "{line}: {report}");
        let picture = png::Decoder::new(std::io::Cursor::new(std::fs::read(folder.path().join("a.png")).unwrap()));
        let reader = picture.read_info().unwrap();
        assert_eq!((reader.info().width, reader.info().height), (2 * 48 + 8, 32), "{line}");
    }
    for (line, expected) in [
        ("cull veils", "0 of 201 instances are veils"),
        ("cull veils --veil ball=2", "`ball=2` is no veil"),
        ("cull veils --veil glass=0.5", "no instance or mesh of scene `crowd-200` is named `glass`"),
        ("cull veils --veil *=0.5", "201 of 201 instances are veils"),
        ("cull detail --veil ball=0.5", "belong to `cull veils`"),
        ("cull detail --light 1,2,3/0,0,0", "a light belongs to `cull volumes`"),
        ("cull prisms --scene palms", "prisms are those of the scene `hall`"),
        ("cull detail --scene palms", "scene `palms` has no camera"),
        ("cull volumes --scene hall", "there is no camera `light`"),
    ] {
        let output = sightlines(&folder, line);
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{line}: {message}");
        assert!(message.contains(expected) && message.contains("remedy"), "{line}: {message}");
    }
}
