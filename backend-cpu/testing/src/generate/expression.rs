//! Random expressions of a wanted type, and places to read and write.

use super::random::Random;
use super::types::{BOOL, F32, I32, Scalar, Type, U32};

const FLOAT_FUNCTIONS: [&str; 20] = [
    "sqrt",
    "inverseSqrt",
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "sinh",
    "cosh",
    "tanh",
    "asinh",
    "acosh",
    "atanh",
    "exp",
    "exp2",
    "log",
    "log2",
    "degrees",
    "radians",
];

const PACKED: [[&str; 2]; 5] = [
    ["pack4x8snorm", "vec4<f32>"],
    ["pack4x8unorm", "vec4<f32>"],
    ["pack2x16snorm", "vec2<f32>"],
    ["pack2x16unorm", "vec2<f32>"],
    ["pack2x16float", "vec2<f32>"],
];

const COMMON: [&str; 5] = ["(lane + 1u)", "(own * 3u)", "(params[0].x + lane)", "input[lane]", "input[own + 1u]"];

/// A variable in scope.
#[derive(Clone)]
pub(crate) struct Variable {
    pub name: String,
    pub ty: Type,
    pub writable: bool,
}

/// What expressions may refer to.
pub(crate) struct Scope<'r> {
    pub random: Random<'r>,
    pub structs: Vec<Vec<Type>>,
    pub variables: Vec<Variable>,
    /// Expressions that read shared memory in the present phase, all u32.
    pub shared: Vec<&'static str>,
    /// Whether programs may run on for ever, race, and meet barriers in divergent control flow.
    pub wild: bool,
}

impl Scope<'_> {
    /// The type of a part and its accessor, at random; none for scalars. Indices of arrays may be out of range.
    fn part(&mut self, ty: &Type, depth: usize) -> Option<(String, Type)> {
        match ty {
            Type::Scalar(_) => None,
            Type::Vector(n, scalar) => {
                let at = self.random.below(*n);
                let access = match self.random.below(3) {
                    0 => format!(".{}", ["x", "y", "z", "w"][at]),
                    1 => format!("[{at}]"),
                    _ => format!("[{}]", self.index(depth)),
                };
                Some((access, Type::Scalar(*scalar)))
            }
            Type::Matrix(columns, rows) => {
                let constant = self.random.chance(50);
                let at = self.random.below(*columns);
                let access = if constant { format!("[{at}]") } else { format!("[{}]", self.index(depth)) };
                Some((access, Type::Vector(*rows, Scalar::F32)))
            }
            Type::Array(element, n) => {
                let constant = self.random.chance(30);
                let at = self.random.below(*n);
                let access = if constant { format!("[{at}u]") } else { format!("[{}]", self.index(depth)) };
                Some((access, (**element).clone()))
            }
            Type::Struct(index) => {
                let members = self.structs[*index].clone();
                let at = self.random.below(members.len());
                Some((format!(".m{at}"), members[at].clone()))
            }
        }
    }

    /// An index that is mostly in range.
    fn index(&mut self, depth: usize) -> String {
        if depth == 0 {
            let word = self.word();
            return if self.random.chance(30) { word } else { format!("{word} % {}u", 1 + self.random.below(6)) };
        }
        let (ty, literal) = if self.random.chance(70) { (U32, "u") } else { (I32, "") };
        let index = self.expression(&ty, depth - 1);
        if self.random.chance(70) { format!("({index}) % {}{literal}", 1 + self.random.below(6)) } else { index }
    }

    /// A place of type `wanted` inside some variable.
    pub(crate) fn place(&mut self, wanted: &Type, writable: bool, depth: usize) -> Option<String> {
        for _ in 0..12 {
            let candidates: Vec<usize> =
                (0..self.variables.len()).filter(|&i| !writable || self.variables[i].writable).collect();
            if candidates.is_empty() {
                return None;
            }
            let variable = self.variables[*self.random.pick(&candidates)].clone();
            if variable.ty == *wanted {
                return Some(variable.name);
            }
            let (mut text, mut ty) = (variable.name, variable.ty);
            while let Some((access, part)) = self.part(&ty, depth) {
                text.push_str(&access);
                ty = part;
                if ty == *wanted {
                    return Some(text);
                }
            }
        }
        None
    }

    /// A writable place and its type.
    pub(crate) fn target(&mut self) -> Option<(String, Type)> {
        let candidates: Vec<Variable> = self.variables.iter().filter(|v| v.writable).cloned().collect();
        if candidates.is_empty() {
            return None;
        }
        let variable = self.random.pick(&candidates).clone();
        let (mut text, mut ty) = (variable.name, variable.ty);
        while self.random.chance(if matches!(ty, Type::Array(..) | Type::Struct(_)) { 85 } else { 35 }) {
            let Some((access, part)) = self.part(&ty, 1) else { break };
            text.push_str(&access);
            ty = part;
        }
        Some((text, ty))
    }

    /// Something that is not constant.
    fn leaf(&mut self, ty: &Type) -> String {
        if let Some(place) = self.place(ty, false, 0) {
            return place;
        }
        match ty {
            Type::Scalar(Scalar::U32) => self.word(),
            Type::Scalar(Scalar::I32) => format!("bitcast<i32>({})", self.word()),
            Type::Scalar(Scalar::F32) => format!("f32({} & 1023u)", self.word()),
            Type::Scalar(Scalar::Bool) => format!("(({} & 1u) == 0u)", self.word()),
            Type::Vector(n, scalar) => self.construct(ty, &vec![Type::Scalar(*scalar); *n], 0),
            Type::Matrix(columns, rows) => self.construct(ty, &vec![Type::Vector(*rows, Scalar::F32); *columns], 0),
            Type::Array(element, n) => self.construct(ty, &vec![(**element).clone(); *n], 0),
            Type::Struct(index) => self.construct(ty, &self.structs[*index].clone(), 0),
        }
    }

    /// A u32 from memory or a builtin id.
    fn word(&mut self) -> String {
        match self.random.below(8) {
            // Repeated often, so that values are shared between far places.
            6 | 7 => (*self.random.pick(&COMMON)).to_owned(),
            0 => "lane".to_owned(),
            1 => "own".to_owned(),
            2 => format!("params[{}].{}", self.random.below(4), self.random.pick(&["x", "y", "z", "w"])),
            3 if !self.shared.is_empty() => (*self.random.pick(&self.shared.clone())).to_owned(),
            4 => format!("input[(lane * {}u + {}u) % 64u]", 1 + self.random.below(9), self.random.below(64)),
            _ => format!("input[{}u]", self.random.below(64)),
        }
    }

    pub(crate) fn construct(&mut self, ty: &Type, parts: &[Type], depth: usize) -> String {
        let parts: Vec<String> = parts.iter().map(|p| self.expression(p, depth)).collect();
        format!("{}({})", ty.name(), parts.join(", "))
    }

    fn literal(&mut self, scalar: Scalar) -> String {
        match scalar {
            Scalar::Bool => self.random.chance(50).to_string(),
            Scalar::U32 => format!("{}u", self.random.word()),
            Scalar::I32 => format!("i32({})", (self.random.word() as i32).max(i32::MIN + 1)),
            Scalar::F32 => {
                format!("{:?}f", *self.random.pick(&[0.0, 0.5, 1.0, -1.0, 2.0, 0.1, 3.25, -7.5, 1e10, 1e-3]))
            }
        }
    }

    /// A right operand: a literal or an expression.
    fn operand(&mut self, ty: &Type, depth: usize) -> String {
        match ty {
            Type::Scalar(scalar) if self.random.chance(35) => self.literal(*scalar),
            Type::Vector(n, scalar) if self.random.chance(15) => {
                format!("vec{n}<{}>({})", scalar.name(), self.literal(*scalar))
            }
            _ => self.expression(ty, depth),
        }
    }

    /// An expression of type `ty` that is not constant.
    pub(crate) fn expression(&mut self, ty: &Type, depth: usize) -> String {
        if depth == 0 || self.random.chance(20) {
            return self.leaf(ty);
        }
        let d = depth - 1;
        match ty {
            Type::Scalar(Scalar::Bool) => self.boolean(d),
            Type::Scalar(scalar) => self.scalar(*scalar, d),
            Type::Vector(n, scalar) => self.vector(*n, *scalar, d),
            Type::Matrix(columns, rows) => self.matrix(*columns, *rows, d),
            Type::Array(..) | Type::Struct(_) => self.leaf(ty),
        }
    }

    fn boolean(&mut self, d: usize) -> String {
        match self.random.below(8) {
            0 => format!("!({})", self.expression(&BOOL, d)),
            1 => {
                let op = *self.random.pick(&["&&", "||", "&", "|", "==", "!="]);
                format!("(({}) {op} ({}))", self.expression(&BOOL, d), self.expression(&BOOL, d))
            }
            2 => {
                let n = 2 + self.random.below(3);
                let fun = *self.random.pick(&["all", "any"]);
                format!("{fun}({})", self.expression(&Type::Vector(n, Scalar::Bool), d))
            }
            3 => format!("bool({})", self.expression(&U32, d)),
            _ => {
                let ty = Type::Scalar(*self.random.pick(&[Scalar::I32, Scalar::U32, Scalar::F32]));
                let op = *self.random.pick(&["<", "<=", ">", ">=", "==", "!="]);
                format!("(({}) {op} ({}))", self.expression(&ty, d), self.operand(&ty, d))
            }
        }
    }

    fn scalar(&mut self, scalar: Scalar, d: usize) -> String {
        let ty = Type::Scalar(scalar);
        match (self.random.below(10), scalar) {
            (0, _) => {
                let (no, yes, c) = (self.expression(&ty, d), self.operand(&ty, d), self.expression(&BOOL, d));
                format!("select({no}, {yes}, {c})")
            }
            (1, Scalar::F32) => format!("f32({})", {
                let from = *self.random.pick(&Scalar::ALL);
                self.expression(&Type::Scalar(from), d)
            }),
            (1, _) => {
                let from = *self.random.pick(&Scalar::ALL);
                format!("{}({})", scalar.name(), self.expression(&Type::Scalar(from), d))
            }
            (2, Scalar::F32) => self.float_of_vectors(d),
            (2, _) => {
                let vector = Type::Vector(2 + self.random.below(3), scalar);
                format!("dot({}, {})", self.expression(&vector, d), self.expression(&vector, d))
            }
            (3, Scalar::U32) => match self.random.below(4) {
                0 => self.packed(d),
                1 => format!("u32(frexp({}).exp)", self.finite(d)),
                _ => format!("bits({})", self.expression(&F32, d)),
            },
            (3, Scalar::I32) => format!("bitcast<i32>({})", self.expression(&U32, d)),
            _ => self.elementwise(&ty, scalar, d),
        }
    }

    fn float_of_vectors(&mut self, d: usize) -> String {
        let vector = Type::Vector(2 + self.random.below(3), Scalar::F32);
        match self.random.below(8) {
            4 => format!("modf({}).{}", self.expression(&F32, d), self.random.pick(&["fract", "whole"])),
            5 => format!("frexp({}).fract", self.finite(d)),
            6 => {
                let (fun, n) = *self.random.pick(&[
                    ("unpack4x8snorm", 4),
                    ("unpack4x8unorm", 4),
                    ("unpack2x16snorm", 2),
                    ("unpack2x16unorm", 2),
                    ("unpack2x16float", 2),
                ]);
                format!("{fun}({})[{}]", self.expression(&U32, d), self.random.below(n))
            }
            0 => format!("length({})", self.expression(&vector, d)),
            1 => format!("distance({}, {})", self.expression(&vector, d), self.expression(&vector, d)),
            2 => {
                let n = 2 + self.random.below(3);
                format!("determinant({})", self.expression(&Type::Matrix(n, n), d))
            }
            _ => format!("dot({}, {})", self.expression(&vector, d), self.expression(&vector, d)),
        }
    }

    /// A packed vector of finite numbers, so that no payload of a NaN shows.
    fn packed(&mut self, d: usize) -> String {
        let [fun, ty] = *self.random.pick(&PACKED);
        let n = if ty == "vec4<f32>" { 4 } else { 2 };
        let parts: Vec<String> = (0..n).map(|_| self.finite(d)).collect();
        format!("{fun}({ty}({}))", parts.join(", "))
    }

    /// A finite f32.
    fn finite(&mut self, d: usize) -> String {
        format!("f32(i32({}))", self.expression(&F32, d))
    }

    /// Operators and functions that work on scalars and, component by component, on vectors.
    fn elementwise(&mut self, ty: &Type, scalar: Scalar, d: usize) -> String {
        let x = self.expression(ty, d);
        match scalar {
            Scalar::Bool => {
                let op = *self.random.pick(&["&", "|", "==", "!="]);
                format!("(({x}) {op} ({}))", self.expression(ty, d))
            }
            Scalar::F32 => self.float_operation(ty, &x, d),
            _ => self.integer_operation(ty, scalar, &x, d),
        }
    }

    fn integer_operation(&mut self, ty: &Type, scalar: Scalar, x: &str, d: usize) -> String {
        match self.random.below(12) {
            0..=3 => {
                let op = *self.random.pick(&["+", "-", "*", "&", "|", "^"]);
                format!("(({x}) {op} ({}))", self.operand(ty, d))
            }
            4 => {
                let op = *self.random.pick(&["/", "%"]);
                format!("(({x}) {op} ({}))", self.expression(ty, d))
            }
            5 => {
                let op = *self.random.pick(&["<<", ">>"]);
                let amount = match ty {
                    Type::Vector(n, _) => self.expression(&Type::Vector(*n, Scalar::U32), d),
                    _ if self.random.chance(50) => format!("{}u", self.random.below(32)),
                    _ => self.expression(&U32, d),
                };
                format!("(({x}) {op} ({amount}))")
            }
            6 => {
                let fun = *self.random.pick(&["min", "max"]);
                format!("{fun}({x}, {})", self.operand(ty, d))
            }
            7 => format!("clamp({x}, {}, {})", self.expression(ty, d), self.operand(ty, d)),
            8 => {
                let fun = *self.random.pick(&[
                    "countOneBits",
                    "countLeadingZeros",
                    "countTrailingZeros",
                    "reverseBits",
                    "firstLeadingBit",
                    "firstTrailingBit",
                    "abs",
                    "~",
                ]);
                format!("{fun}({x})")
            }
            9 => format!("extractBits({x}, {}, {})", self.expression(&U32, d), self.expression(&U32, d)),
            10 => {
                let bits = self.expression(ty, d);
                format!("insertBits({x}, {bits}, {}, {})", self.expression(&U32, d), self.expression(&U32, d))
            }
            _ if scalar == Scalar::I32 => {
                let fun = *self.random.pick(&["-", "sign", "abs"]);
                format!("{fun}({x})")
            }
            _ => format!("(({x}) % {}u)", 1 + self.random.below(40)),
        }
    }

    fn float_operation(&mut self, ty: &Type, x: &str, d: usize) -> String {
        match self.random.below(12) {
            0..=4 => {
                let op = *self.random.pick(&["+", "-", "*", "*", "/"]);
                format!("(({x}) {op} ({}))", self.operand(ty, d))
            }
            5 => {
                let fun =
                    *self.random.pick(&["floor", "ceil", "trunc", "round", "fract", "abs", "-", "sign", "saturate"]);
                format!("{fun}({x})")
            }
            6 => format!("{}({x})", self.random.pick(&FLOAT_FUNCTIONS)),
            7 => {
                let fun = *self.random.pick(&["min", "max", "step", "pow", "atan2"]);
                format!("{fun}({x}, {})", self.expression(ty, d))
            }
            8 => {
                let fun = *self.random.pick(&["clamp", "mix", "fma", "smoothstep"]);
                format!("{fun}({x}, {}, {})", self.expression(ty, d), self.expression(ty, d))
            }
            9 => format!("(({x}) % ({}))", self.expression(ty, d)),
            10 => format!("quantizeToF16({x})"),
            _ => {
                let exponent = match ty {
                    Type::Vector(n, _) => Type::Vector(*n, Scalar::I32),
                    _ => I32,
                };
                format!("ldexp({x}, {})", self.expression(&exponent, d))
            }
        }
    }

    fn vector(&mut self, n: usize, scalar: Scalar, d: usize) -> String {
        let ty = Type::Vector(n, scalar);
        match self.random.below(8) {
            0 => self.construct(&ty, &vec![Type::Scalar(scalar); n], d),
            1 => format!("{}({})", ty.name(), self.expression(&Type::Scalar(scalar), d)),
            2 => {
                let from = 2 + self.random.below(3);
                let swizzle: String = (0..n).map(|_| *self.random.pick(&['x', 'y', 'z', 'w'][..from])).collect();
                format!("({}).{swizzle}", self.expression(&Type::Vector(from, scalar), d))
            }
            3 if scalar == Scalar::Bool => {
                let operand = Type::Vector(n, *self.random.pick(&[Scalar::I32, Scalar::U32, Scalar::F32]));
                let op = *self.random.pick(&["<", "<=", ">", ">=", "==", "!="]);
                format!("(({}) {op} ({}))", self.expression(&operand, d), self.expression(&operand, d))
            }
            3 if scalar == Scalar::F32 => {
                let columns = 2 + self.random.below(3);
                let matrix = self.expression(&Type::Matrix(columns, n), d);
                format!("(({matrix}) * ({}))", self.expression(&Type::Vector(columns, Scalar::F32), d))
            }
            4 if scalar == Scalar::F32 && self.random.chance(50) => self.geometric(n, d),
            4 => {
                let condition = Type::Vector(n, Scalar::Bool);
                let (no, yes) = (self.expression(&ty, d), self.operand(&ty, d));
                format!("select({no}, {yes}, {})", self.expression(&condition, d))
            }
            5 if scalar != Scalar::Bool => {
                format!("(({}) * ({}))", self.expression(&ty, d), self.expression(&Type::Scalar(scalar), d))
            }
            _ => self.elementwise(&ty, scalar, d),
        }
    }

    /// Functions of whole vectors.
    fn geometric(&mut self, n: usize, d: usize) -> String {
        let ty = Type::Vector(n, Scalar::F32);
        let [a, b, c] = [0, 1, 2].map(|_| self.expression(&ty, d.min(1)));
        match self.random.below(5) {
            0 if n == 3 => format!("cross({a}, {b})"),
            0 | 1 => format!("normalize({a})"),
            2 => format!("reflect({a}, {b})"),
            3 => format!("faceForward({a}, {b}, {c})"),
            _ => format!("refract({a}, {b}, {})", self.expression(&F32, d.min(1))),
        }
    }

    fn matrix(&mut self, columns: usize, rows: usize, d: usize) -> String {
        let ty = Type::Matrix(columns, rows);
        match self.random.below(5) {
            0 => self.construct(&ty, &vec![Type::Vector(rows, Scalar::F32); columns], d),
            1 => {
                let op = *self.random.pick(&["+", "-"]);
                format!("(({}) {op} ({}))", self.expression(&ty, d), self.expression(&ty, d))
            }
            2 => format!("(({}) * ({}))", self.expression(&ty, d), self.expression(&F32, d)),
            3 => format!("transpose({})", self.expression(&Type::Matrix(rows, columns), d)),
            _ => {
                let inner = 2 + self.random.below(3);
                let left = self.expression(&Type::Matrix(inner, rows), d.min(1));
                format!("(({left}) * ({}))", self.expression(&Type::Matrix(columns, inner), d.min(1)))
            }
        }
    }
}
