// Counts become starts: each becomes the sum of those before it. In three passes: sums within blocks,
// the sums of the blocks, and both together. A block is one workgroup, PER_BLOCK counts.
// Needs common/index, rows.

@group(0) @binding(0) var<uniform> scan: Scan;
@group(0) @binding(1) var<storage, read> counts: array<u32>;
@group(0) @binding(2) var<storage, read_write> starts: array<u32>;
@group(0) @binding(3) var<storage, read_write> blocks: array<u32>;
@group(0) @binding(4) var<storage, read_write> status: array<atomic<u32>>;

const LANES: u32 = 256u;
const PER_LANE: u32 = 16u;
const PER_BLOCK: u32 = 4096u;

var<workgroup> sums: array<u32, LANES>;

// ANCHOR: scan_lanes
// The sum of `value` over the lanes before this one; `sums[LANES - 1]` is then the sum over all.
fn scan_lanes(lane: u32, value: u32) -> u32 {
    sums[lane] = value;
    for (var reach = 1u; reach < LANES; reach *= 2u) {
        workgroupBarrier();
        var sum = sums[lane];
        if lane >= reach {
            sum += sums[lane - reach];
        }
        workgroupBarrier();
        sums[lane] = sum;
    }
    workgroupBarrier();
    return sums[lane] - value;
}
// ANCHOR_END: scan_lanes

// Whether the starts are to be written: where there is no room, those of the step that lacks it stay.
fn has_room() -> bool {
    return atomicLoad(&status[NEEDED]) <= scan.room;
}

// Sums within a block.
@compute @workgroup_size(LANES)
fn scan_blocks(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let block = group_index(group);
    let first = block * PER_BLOCK + lane * PER_LANE;
    var own: array<u32, PER_LANE>;
    var sum = 0u;
    for (var k = 0u; k < PER_LANE; k++) {
        own[k] = sum;
        if first + k < scan.counts {
            sum += counts[first + k];
        }
    }
    let before = scan_lanes(lane, sum);
    let writes = has_room();
    for (var k = 0u; k < PER_LANE; k++) {
        if writes && first + k < scan.counts {
            starts[first + k] = before + own[k];
        }
    }
    if lane == LANES - 1u && block * PER_BLOCK < scan.counts {
        blocks[block] = sums[lane];
    }
}

// The sums of the blocks, by one workgroup.
@compute @workgroup_size(LANES)
fn scan_sums(@builtin(local_invocation_index) lane: u32) {
    let count = (scan.counts + PER_BLOCK - 1u) / PER_BLOCK;
    let per_lane = (count + LANES - 1u) / LANES;
    var sum = 0u;
    for (var k = 0u; k < per_lane; k++) {
        let block = lane * per_lane + k;
        if block < count {
            sum += blocks[block];
        }
    }
    var before = scan_lanes(lane, sum);
    for (var k = 0u; k < per_lane; k++) {
        let block = lane * per_lane + k;
        if block < count {
            let own = blocks[block];
            blocks[block] = before;
            before += own;
        }
    }
}

// Both together.
@compute @workgroup_size(WORKGROUP)
fn scan_add(@builtin(global_invocation_id) id: vec3u) {
    let place = row_index(id);
    if place < scan.counts && has_room() {
        starts[place] += blocks[place / PER_BLOCK];
    }
}
