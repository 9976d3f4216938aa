//! Messages about params.

use super::{Words, wording};
use crate::model::{JointId, ParamId};

impl Words<'_> {
    /// The name of a param.
    pub(super) fn param(&self, param: ParamId) -> &str {
        &self.model.params.all()[param.index()].name
    }

    pub(super) fn matched_only(&self, joints: &[JointId], param: ParamId) -> String {
        let param = self.param(param);
        let names: Vec<String> = joints.iter().map(|&joint| self.joint(joint)).collect();
        let some = wording::one_of(&names);
        format!(
            "this mechanism moves only as long as its lengths match, and param `{param}` may change one\nhelp: write `const \
             {param}`, or remove {some}"
        )
    }
}
