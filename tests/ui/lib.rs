//! Nothing: what is tested is how programs that use the macro fail.
