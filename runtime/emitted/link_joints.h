#pragma once
// What the table says of links and their joints.

/// The inertial parameters of link `i`.
TL_INLINE const TlLinkBody* tl_body_of(const TlLinkTable* table, int32_t i) {
  const TlLinkBody* body = &table->links[i].body;
  if (TL_LOADED) {
    for (int32_t k = 0; k < table->loaded_count; ++k) {
      if (table->loaded_links[k] == i) {
        body = &table->bodies[k];
      }
    }
  }
  return body;
}

/// Whose coordinate the joint of link `i` has, counted without joints that share
/// those of others.
TL_INLINE int32_t tl_joint_of(const TlLinkTable* table, int32_t i) {
  if (TL_COUPLED) {
    return table->couplings[i].joint;
  } else {
    (void)table;
    return i;
  }
}

/// Joints that have coordinates of their own, a floating base among them.
TL_INLINE int32_t tl_count_joints(const TlLinkTable* table) {
  if (TL_COUPLED) {
    return table->joints;
  } else {
    return table->count;
  }
}

/// What the joint of link `i` makes of its coordinate, or the coordinate of a force
/// along it.
TL_INLINE real tl_scale(const TlLinkTable* table, int32_t i, real value) {
  if (TL_COUPLED) {
    return table->couplings[i].multiplier * value;
  } else {
    (void)table;
    (void)i;
    return value;
  }
}

/// Puts `value` in its place, or adds it where joints share that.
TL_INLINE void tl_enter(real value, real* place) {
  if (TL_COUPLED) {
    *place = (*place) + value;
  } else {
    *place = value;
  }
}

/// The inertia that the joint of link `i` alone feels.
TL_INLINE real tl_rotor_of(const TlLinkTable* table, int32_t i) {
  real rotor = table->links[i].rotor;
  if (TL_STEPPED) {
    if (table->rotors != TL_NONE) {
      rotor = table->rotors[i];
    }
  }
  return rotor;
}

/// Where row `r` of the points has its numbers in arguments and results.
TL_INLINE int32_t tl_entry_of(const TlLinkTable* table, int32_t r) {
  if (TL_SORTED) {
    return table->row_entries[r];
  } else {
    (void)table;
    return r;
  }
}

/// Where joint `i` has its velocity.
TL_INLINE int32_t tl_velocity_at(int32_t i) {
  if (TL_FLOATS) {
    int32_t at = i;
    if (i > 0) {
      at = i + 5;
    }
    return at;
  } else {
    return i;
  }
}

/// Where the joint of link `i` has its coordinate.
TL_INLINE int32_t tl_coordinate_of(const TlLinkTable* table, int32_t i) {
  int32_t at = tl_velocity_at(tl_joint_of(table, i));
  if (TL_FLOATS) {
    if (at > 0) {
      at = at + 1;
    }
  }
  if (TL_BALLS) {
    at = table->ball_axes[i].q;
  }
  return at;
}

/// Which axis of a ball joint link `i` has: 0 if none.
TL_INLINE int32_t tl_ball_axis(const TlLinkTable* table, int32_t i) {
  if (TL_BALLS) {
    return table->ball_axes[i].axis;
  } else {
    (void)table;
    (void)i;
    return 0;
  }
}

/// Where the rotation of link `i` is, which has the first axis of a ball joint.
TL_INLINE int32_t tl_rotation_at(const TlLinkTable* table, int32_t i) {
  if (TL_BALLS) {
    return table->ball_axes[i].rotation;
  } else {
    (void)table;
    (void)i;
    return 0;
  }
}

/// Whether link `i` is a floating base.
TL_INLINE bool tl_is_floating(int32_t i) {
  if (TL_FLOATS) {
    return i == 0;
  } else {
    (void)i;
    return false;
  }
}

/// Whether what has this number for its link is on the world.
TL_INLINE bool tl_is_on_world(int32_t link) {
  if (TL_GROUNDED) {
    return link < 0;
  } else {
    (void)link;
    return false;
  }
}

/// Whether the joint of link `i` is prismatic.
TL_INLINE bool tl_slides(const TlLinkTable* table, int32_t i) {
  if (TL_SLIDING) {
    return table->links[i].slides;
  } else {
    (void)table;
    (void)i;
    return false;
  }
}

/// Whether link `i` is the first of a joint beyond the base that moves freely.
TL_INLINE bool tl_is_freed(const TlLinkTable* table, int32_t i) {
  if (TL_FREED) {
    return (tl_ball_axis(table, i) == 1) && tl_slides(table, i);
  } else {
    (void)table;
    (void)i;
    return false;
  }
}

/// Whether link `i` is a rotor, whose angle does not matter.
TL_INLINE bool tl_spins(const TlLinkTable* table, int32_t i) {
  if (TL_COUPLED) {
    return table->couplings[i].spins;
  } else {
    (void)table;
    (void)i;
    return false;
  }
}

/// The entry of a wrench or twist along or about the joint's axis.
TL_INLINE real* tl_along_joint(
    const TlLinkTable* table, int32_t i, TlSpatial* spatial) {
  real* const half = tl_slides(table, i) ? &spatial->linear[0] : &spatial->angular[0];
  return &half[2];
}
