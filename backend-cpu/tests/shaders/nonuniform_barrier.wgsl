// A barrier that some invocations of a workgroup do not reach is refused, not passed. The front end cannot know.
//! buffer 0: u32 0 1 0 1
//! dispatch: main 1 1 1
//! fails: barrier

@group(0) @binding(0) var<storage, read_write> data: array<u32>;

@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) i: u32) {
    if data[i] == 1u {
        workgroupBarrier();
    }
    data[i] = 5u;
}
