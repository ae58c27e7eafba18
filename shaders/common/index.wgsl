// Which row an invocation has, and how workgroups are counted. Beyond what one line of workgroups can
// count, they stand in lines of GROUPS_ACROSS, one behind the other.

// Invocations of a workgroup, where a kernel has no reason for another number.
override WORKGROUP: u32 = 64u;

// Workgroups in a line. `stream::passes` has it too.
const GROUPS_ACROSS: u32 = 32768u;

// The number of a workgroup, from @builtin(workgroup_id).
fn group_index(group: vec3u) -> u32 {
    return group.x + GROUPS_ACROSS * group.y;
}

// The row of an invocation, from @builtin(global_invocation_id), in a kernel of WORKGROUP invocations.
fn row_index(id: vec3u) -> u32 {
    return id.x + GROUPS_ACROSS * WORKGROUP * id.y;
}

// The workgroups that a pass over so many rows needs, for a run whose length the GPU decides.
fn groups_for(rows: u32) -> vec3u {
    let groups = (rows + WORKGROUP - 1u) / WORKGROUP;
    if groups <= 65535u {
        return vec3u(groups, 1u, 1u);
    }
    return vec3u(GROUPS_ACROSS, (groups + GROUPS_ACROSS - 1u) / GROUPS_ACROSS, 1u);
}
