//! Words of literals and of constant expressions.

use naga::{Arena, Expression, Handle};

use super::build::{Builder, Fail};

impl<'m> Builder<'m> {
    /// Words of a constant expression.
    pub(super) fn constant_words(
        &self,
        arena: &'m Arena<Expression>,
        handle: Handle<Expression>,
    ) -> Result<Vec<u32>, Fail> {
        let fail = |what: &str| Err(Fail::unsupported(what.to_owned(), Some(arena.get_span(handle))));
        Ok(match &arena[handle] {
            Expression::Literal(literal) => vec![literal_word(*literal)?],
            Expression::Constant(constant) => {
                self.constant_words(&self.module.global_expressions, self.module.constants[*constant].init)?
            }
            Expression::Override(handle) => match self.module.overrides[*handle].init {
                Some(init) => self.constant_words(&self.module.global_expressions, init)?,
                None => return fail("an override without a value"),
            },
            Expression::ZeroValue(ty) => vec![0; self.flat(self.inner(*ty))? as usize],
            Expression::Compose { components, .. } => {
                let mut words = Vec::new();
                for component in components {
                    words.extend(self.constant_words(arena, *component)?);
                }
                words
            }
            Expression::Splat { size, value } => {
                let value = self.constant_words(arena, *value)?;
                value.repeat(*size as usize)
            }
            _ => return fail("this constant expression"),
        })
    }
}

/// The word of a literal.
pub(super) fn literal_word(literal: naga::Literal) -> Result<u32, Fail> {
    Ok(match literal {
        naga::Literal::F32(value) => value.to_bits(),
        naga::Literal::U32(value) => value,
        naga::Literal::I32(value) => value as u32,
        naga::Literal::Bool(value) => {
            if value {
                u32::MAX
            } else {
                0
            }
        }
        other => return Err(Fail::unsupported(format!("the literal {other:?}"), None)),
    })
}
