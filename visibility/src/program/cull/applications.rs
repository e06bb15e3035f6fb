//! The applications of `sightlines cull`: what each counts, culls, checks and draws.

use sightlines_backend::Backend;
use sightlines_visibility::error::{Place, Result};
use sightlines_visibility::queries::detail::{Level, choose};
use sightlines_visibility::queries::displacement::{Scene, displace};
use sightlines_visibility::queries::picture::{Pixels, shaded};
use sightlines_visibility::queries::transparency::{FULL, Veil, Veiled, query_veiled};
use sightlines_visibility::queries::{Answer, Painted, Spent, Stage, draw, query, shadow_volumes};
use sightlines_visibility::scene::frame::Frame;
use sightlines_visibility::scene::{Camera, World, ball_levels, creature_field};

use super::{CullArgs, Found};
use crate::program::Failure;
use crate::program::queries::extents;

const GREY: [u8; 3] = [150, 150, 150];
const ORANGE: [u8; 3] = [240, 150, 60];
const YELLOW: [u8; 3] = [235, 220, 90];
const GREEN: [u8; 3] = [120, 200, 110];
const BLUE: [u8; 3] = [70, 110, 230];
/// Light that veils give off where they hide.
const SMOKE: [u8; 3] = [205, 205, 215];

/// How far volumes reach, in distances from the light.
const REACH: f64 = 1.0;
/// Height of the creature's relief.
const HEIGHT: f64 = 0.06;
/// Pixels from which balls have 606 and 168 triangles.
const FINE: [u32; 2] = [200, 50];

/// A picture from a camera in colours of instances.
fn panel(
    args: &CullArgs,
    backend: &dyn Backend,
    world: &World,
    (camera, instances): (&Camera, &[usize]),
    paint: impl Fn(usize, usize) -> [u8; 3],
) -> Result<Pixels> {
    let frame = Frame::new(camera, args.size, world.corners().as_flattened())?;
    shaded(backend, world, frame, (instances, camera.eye), paint)
}

/// The camera's eye lifted high over what it looks at.
fn from_above(args: &CullArgs, world: &World, camera: &Camera) -> Result<Camera> {
    let extents = extents(world);
    let middle = extents.map(|[low, high]| 0.5 * low + 0.5 * high);
    let up = args.up.vector();
    let widest = extents.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
    let eye = [0, 1, 2].map(|axis| middle[axis] + 1.1 * widest * up[axis] - 0.6 * widest * camera.forward[axis]);
    Camera::look_at("above", eye, middle, up, camera.lens)
}

fn spent(of: impl IntoIterator<Item = Spent>) -> String {
    let ops: Option<u64> = of.into_iter().map(|spent| spent.lane_ops).sum();
    ops.map_or_else(|| "not counted by this machine".to_owned(), |ops| format!("{ops} lane-operations"))
}

fn differing<T: PartialEq>(a: &[T], b: &[T]) -> u64 {
    a.iter().zip(b).filter(|(a, b)| a != b).count() as u64
}

/// The same picture, or a failure.
fn equal(a: &Painted, b: &Painted) -> Result<(), Failure> {
    match differing(&a.depths, &b.depths) + differing(&a.instances, &b.instances) {
        0 => Ok(()),
        words => Err(Failure::Lost(words)),
    }
}

fn seen(answer: &Answer) -> Vec<usize> {
    let items = answer.items.iter().zip(&answer.totals);
    items.filter(|(_, pixels)| **pixels > 0).map(|(item, _)| item.instance).collect()
}

fn members(world: &World, instances: &[usize]) -> Vec<bool> {
    let mut all = vec![false; world.instances.len()];
    instances.iter().for_each(|instance| all[*instance] = true);
    all
}

pub(super) fn volumes(args: &CullArgs, backend: &dyn Backend, world: &World) -> Result<Found, Failure> {
    let light = args.view(args.light.as_ref(), Some("light"), world, "--light")?;
    let camera = args.view(args.camera.as_ref(), None, world, "--camera")?;
    let frame = Frame::new(&light, args.size, world.corners().as_flattened())?;
    let stage = Stage::of(world, frame)?;
    let answer = query(backend, &stage, args.method(), 0, &mut |_| ())?;
    let lit = seen(&answer);
    let kept = members(world, &lit);
    equal(&draw(backend, &stage)?, &draw(backend, &stage.part(|instance| kept[instance]))?)?;
    let all: Vec<usize> = (0..world.instances.len()).collect();
    let drawn = |casters: &[usize]| -> Result<(usize, Spent)> {
        let volumes = shadow_volumes::volumes(world, casters, light.eye, REACH);
        let frame = Frame::new(&camera, args.size, volumes.corners().as_flattened())?;
        Ok((volumes.triangle_count(), draw(backend, &Stage::of(&volumes, frame)?)?.draw))
    };
    let [(before, all_drawn), (after, kept_drawn)] = [drawn(&all)?, drawn(&lit)?];
    let lines = vec![
        ("lit", format!("{} of {} instances, from camera {}", lit.len(), all.len(), light.name)),
        ("volumes", format!("{after} of {before} triangles")),
        ("light", "its depths without the culled are those with all, in every pixel".to_owned()),
        ("before", format!("{}: all volumes drawn", spent([all_drawn]))),
        (
            "after",
            format!(
                "{}: the light's view, counts, and the volumes kept",
                spent([answer.cost.draw, answer.cost.count, kept_drawn,])
            ),
        ),
    ];
    let paint = |instance: usize, _: usize| if kept[instance] { ORANGE } else { BLUE };
    let panels = match args.picture {
        None => Vec::new(),
        Some(_) => vec![
            panel(args, backend, world, (&camera, &all), paint)?,
            panel(args, backend, world, (&light, &all), paint)?,
        ],
    };
    Ok(Found { lines, panels })
}

pub(super) fn prisms(args: &CullArgs, backend: &dyn Backend, world: &World) -> Result<Found, Failure> {
    let camera = args.view(args.camera.as_ref(), Some("partial"), world, "--camera")?;
    let scene = Scene::new(world, 0, displace(&world.meshes[0], HEIGHT, 2, creature_field));
    let frame = Frame::new(&camera, args.size, &scene.points())?;
    let culled = scene.cull(backend, frame, args.method(), args.tiles)?;
    let full = draw(backend, &Stage::of(&scene.full, frame)?)?;
    let left = draw(backend, &Stage::of(&scene.extruded(&culled.kept), frame)?)?;
    equal(&full, &left)?;
    let kept = culled.kept.iter().filter(|kept| **kept).count();
    let lines = vec![
        ("kept", format!("{kept} of {} prisms, from camera {}", culled.kept.len(), camera.name)),
        ("picture", "depths and instances without the culled are those with all, in every pixel".to_owned()),
        ("before", format!("{}: all prisms drawn", spent([full.draw]))),
        (
            "after",
            format!("{}: the hull's pass, counts, and the prisms kept", spent([culled.draw, culled.count, left.draw,])),
        ),
    ];
    let pieces = scene.displaced.pieces;
    let paint = |instance: usize, triangle: usize| match instance == scene.instance {
        true if culled.kept[triangle / pieces] => ORANGE,
        true => BLUE,
        false => GREY,
    };
    let all: Vec<usize> = (0..scene.full.instances.len()).collect();
    let panels = match args.picture {
        None => Vec::new(),
        Some(_) => {
            let above = args.view(None, Some("full"), world, "--camera")?;
            vec![
                panel(args, backend, &scene.full, (&camera, &all), paint)?,
                panel(args, backend, &scene.full, (&above, &all), paint)?,
            ]
        }
    };
    Ok(Found { lines, panels })
}

pub(super) fn detail(args: &CullArgs, backend: &dyn Backend, mut world: World) -> Result<Found, Failure> {
    let camera = args.view(args.camera.as_ref(), None, &world, "--camera")?;
    let frame = Frame::new(&camera, args.size, world.corners().as_flattened())?;
    let answer = query(backend, &Stage::of(&world, frame)?, args.method(), 0, &mut |_| ())?;
    let shown = seen(&answer);
    let kept = members(&world, &shown);
    let stage = Stage::of(&world, frame)?;
    let all = draw(backend, &stage)?;
    equal(&all, &draw(backend, &stage.part(|instance| kept[instance]))?)?;
    let triangles = |of: &[usize]| -> usize {
        of.iter().map(|instance| world.meshes[world.instances[*instance].mesh].triangles.len()).sum()
    };
    let mut lines = vec![
        ("seen", format!("{} of {} instances, from camera {}", shown.len(), kept.len(), camera.name)),
        (
            "culled",
            format!("{} of {} triangles drawn, and no pixel changes", triangles(&shown), world.triangle_count()),
        ),
    ];
    let mut coarse = None;
    if world.name.starts_with("crowd-") {
        let fine = world.meshes.iter().position(|mesh| mesh.name == "ball").unwrap_or(0);
        let first = world.meshes.len();
        world.meshes.extend(ball_levels());
        let level = |(mesh, pixels)| Level { mesh, pixels };
        let levels = [(fine, FINE[0]), (first, FINE[1]), (first + 1, 1)].map(level);
        let (chosen, places) = choose(&world, &answer, fine, &levels);
        let drawn = draw(backend, &Stage::of(&chosen, frame)?)?;
        let instances: Vec<Option<usize>> = drawn.instances.iter().map(|i| i.map(|i| places[i])).collect();
        let [changed, pixels] = [differing(&instances, &all.instances), all.instances.len() as u64];
        let what = format!("{} triangles drawn, and {changed} of {pixels} pixels", chosen.triangle_count());
        lines.push(("levels", format!("{what} show another instance")));
        coarse = Some((chosen, places, [fine, first, first + 1]));
    }
    let panels = match (&args.picture, &coarse) {
        (None, _) => Vec::new(),
        (Some(_), None) => {
            let instances = shown.iter().map(|instance| world.instances[*instance].clone()).collect();
            let drawn = World { instances, ..world.clone() };
            levels_panels(args, backend, (&world, &camera), (&drawn, &shown), |_| ORANGE)?
        }
        (Some(_), Some((chosen, places, meshes))) => {
            let colours = [ORANGE, YELLOW, GREEN];
            let level = |mesh: usize| meshes.iter().position(|m| *m == mesh).map_or(GREY, |level| colours[level]);
            levels_panels(args, backend, (&world, &camera), (chosen, places), level)?
        }
    };
    Ok(Found { lines, panels })
}

/// What is drawn, from the camera; and the whole scene from above, in which what is not drawn is blue. `places` are
/// those of the drawn instances in the whole scene.
fn levels_panels(
    args: &CullArgs,
    backend: &dyn Backend,
    (world, camera): (&World, &Camera),
    (drawn, places): (&World, &[usize]),
    level: impl Fn(usize) -> [u8; 3],
) -> Result<Vec<Pixels>> {
    let kept = drawn.instances.len();
    let all: Vec<usize> = (0..world.instances.len()).collect();
    let is_kept = members(world, places);
    let culled = all.iter().filter(|instance| !is_kept[**instance]).map(|instance| world.instances[*instance].clone());
    let both = World { instances: drawn.instances.iter().cloned().chain(culled).collect(), ..drawn.clone() };
    let paint = |instance: usize, _: usize| if instance < kept { level(both.instances[instance].mesh) } else { BLUE };
    let above = from_above(args, &both, camera)?;
    Ok(vec![
        panel(args, backend, &both, (camera, &all[..kept]), paint)?,
        panel(args, backend, &both, (&above, &all), paint)?,
    ])
}

pub(super) fn veils(args: &CullArgs, backend: &dyn Backend, world: &World) -> Result<Found, Failure> {
    let camera = args.view(args.camera.as_ref(), None, world, "--camera")?;
    let veils = named(args, world)?;
    let veiled = |instance: &usize| veils.iter().any(|veil| veil.instance == *instance);
    let opaque: Vec<usize> = (0..world.instances.len()).filter(|instance| !veiled(instance)).collect();
    let frame = Frame::new(&camera, args.size, world.corners().as_flattened())?;
    let before = query_veiled(backend, world, frame, &opaque, &veils, args.method())?;
    let least = (args.least * FULL).max(1);
    let kept = before.kept(least);
    let after = query_veiled(backend, world, frame, &kept, &veils, args.method())?;
    let all: Vec<usize> = (0..world.instances.len()).collect();
    let paint = |instance: usize, _: usize| if veiled(&instance) { SMOKE } else { ORANGE };
    let picture = |seen: &Veiled, instances: &[usize]| -> Result<Pixels> {
        let colours = shaded(backend, world, frame, (instances, camera.eye), paint)?;
        Ok(colours.iter().zip(&seen.weights).map(|(colour, weight)| through(*colour, *weight)).collect())
    };
    let [first, second] = [picture(&before, &opaque)?, picture(&after, &kept)?];
    let changed = differing(&first, &second);
    if args.least == 0 && changed > 0 {
        return Err(Failure::Lost(changed));
    }
    let most = first.as_flattened().iter().zip(second.as_flattened()).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0);
    let seen = seen(&before.answer).len();
    let lines = vec![
        ("veils", format!("{} of {} instances", veils.len(), all.len())),
        ("unveiled", format!("{seen} of {} others show a pixel without regard to veils", opaque.len())),
        ("kept", format!("{} of them, of which at least {} of a pixel is seen", kept.len(), share(least))),
        ("picture", format!("{changed} of {} pixels change, by at most {most} of 255 levels", first.len())),
        (
            "work",
            format!(
                "{}: opaque instances, veils, sums and counts",
                spent([before.answer.cost.draw, before.weigh, before.answer.cost.count,])
            ),
        ),
    ];
    let kept = members(world, &kept);
    let bare = |instance: usize, _: usize| if kept[instance] { ORANGE } else { BLUE };
    let panels = match args.picture {
        None => Vec::new(),
        Some(_) => vec![first, panel(args, backend, world, (&camera, &opaque), bare)?],
    };
    Ok(Found { lines, panels })
}

fn share(least: u32) -> String {
    if least == 1 { "1/255".to_owned() } else { (least / FULL).to_string() }
}

/// A colour behind veils, and what they give off themselves.
fn through(colour: [u8; 3], weight: u32) -> [u8; 3] {
    let mix = |part: usize| u32::from(colour[part]) * weight + u32::from(SMOKE[part]) * (FULL - weight);
    [0, 1, 2].map(|part| (mix(part) / FULL) as u8)
}

/// The veils that the command line names.
fn named(args: &CullArgs, world: &World) -> Result<Vec<Veil>> {
    let mut factors = vec![None; world.instances.len()];
    let refused = |what: String, remedy: &str| Err(Place::default().element("--veil").error(what, remedy));
    for words in &args.veil {
        let parts = words.rsplit_once('=').and_then(|(name, share)| Some((name, share.trim().parse::<f64>().ok()?)));
        let Some((name, share)) = parts.filter(|(_, share)| (0.0..=1.0).contains(share)) else {
            return refused(format!("`{words}` is no veil"), "give a name and a share from 0 to 1, as 'glass*=0.5'");
        };
        let is_named = |has: &str| name.strip_suffix('*').map_or(has == name, |start| has.starts_with(start));
        let mut found = false;
        for (factor, instance) in factors.iter_mut().zip(&world.instances) {
            if is_named(&instance.name) || is_named(&world.meshes[instance.mesh].name) {
                (*factor, found) = (Some((share * 256.0 + 0.5) as u32), true);
            }
        }
        if !found {
            return refused(
                format!("no instance or mesh of scene `{}` is named `{name}`", world.name),
                "see the names \
                with `sightlines queries --csv`",
            );
        }
    }
    let veil = |(instance, factor): (usize, &Option<u32>)| factor.map(|through| Veil { instance, through });
    let veils: Vec<Veil> = factors.iter().enumerate().filter_map(veil).collect();
    if veils.is_empty() || veils.len() == world.instances.len() {
        let what = format!("{} of {} instances are veils", veils.len(), world.instances.len());
        return refused(what, "name some of them, as 'ball 1*=0.05'");
    }
    Ok(veils)
}
