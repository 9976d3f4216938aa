//! Tests of the compiler as a library: what it accepts, offers and computes, by its interpreter. None expands a mechanism.

mod accuracy;
mod alike;
mod anything;
mod assemblies;
mod built_once;
mod catalogue;
mod embedded_page;
mod expand;
mod force;
mod large;
mod looks;
mod mistakes;
mod motion;
mod names;
mod notes;
mod order;
mod params;
mod parts;
mod programs;
mod random;
mod ranges;
mod rates;
mod repairs;
mod shafts;
mod show;
mod slides;
